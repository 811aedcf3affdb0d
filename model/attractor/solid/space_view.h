// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/orbit_camera.h"
#include "attractor/request/space_request.h"
#include "attractor/solid/bend_tree.h"
#include "attractor/solid/bent_word.h"
#include "ifs/cage/cage_surface.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>

namespace attractor {

// A SpaceClip in the coordinates of SpaceView::toPixels: lowest ≤ ⟨normal, x⟩ ≤ highest, the normal a unit
// vector. At least a pixel wide, because nothing thinner is seen.
struct PixelClip {
    ifs::Vector<3> normal = ifs::Vector<3>::UnitX();
    double lowest = 0;
    double highest = 0;

    bool keeps(const ifs::Vector<3>& point) const {
        const double at = normal.dot(point);
        return at >= lowest && at <= highest;
    }
};

// camera · cage in space. An affine map to pixels in the plane of the target: to the right and downwards from
// the middle of the picture, and away from the eye; and an eye, to which all of it shrinks.
// docs/mathematics.md, "Perspective".
struct SpaceView {
    ifs::AffineMap<3> toPixels;
    double eyeDistance = 0; // pixels; 0: orthographic
    RasterSize size;
    std::optional<PixelClip> clip; // hides points outside
    // A cage that bends: then toPixels leaves everything in its place, and a word is straightened on its way
    // to the pixels by what the camera makes of it to first order.
    std::shared_ptr<const ifs::CageDeformation> bend;
    ifs::AffineMap<3> afterBend;
    // Follows it for those words of the view that are walked to from the root; none: each is looked at alone.
    std::shared_ptr<BendTree> bends;

    bool isPerspective() const { return eyeDistance > 0; }
};
SpaceView spaceView(const OrbitCamera& camera, const ifs::AffineMap<3>& cage, double eyeShift = 0);
// The view that `request` asks for with the cage in force.
SpaceView spaceView(const SpaceRequest& request, const ifs::AffineMap<3>& cage);

// Points nearer to the eye than this share of its distance from the target are not drawn.
constexpr double nearestShare = 0x1p-10;

// A word, an affine map of [−1, 1]³ to the coordinates of SpaceView::toPixels, in pixels before perspective:
// where nothing bends, itself. `miss` is by how much its first-order map may be off, by what the middles of
// the six sides and four corners tell.
struct StraightWord {
    ifs::AffineMap<3> word;
    ifs::Vector<3> miss = ifs::Vector<3>::Zero();
};
StraightWord straightened(const ifs::AffineMap<3>& word, const SpaceView& view);

// A word of a walk down the address tree. Once the bend of a word is known well enough, that of the words in
// it follows without looking at the cage again.
struct WalkedWord {
    ifs::AffineMap<3> word{};
    BendTree::Node* node = nullptr;         // nullptr: not a word of SpaceView::bends
    std::shared_ptr<const BentWord> bent{}; // bend of a word that contains this one; not kept beyond the view
    ifs::AffineMap<3> within{};             // this word in coordinates of the bent one
    bool follows = false;                   // true if it follows from `bent` accurately enough

    WalkedWord inside(const ifs::AffineMap<3>& map) const; // word * map
};
// The box of a system, from which a walk begins, and the word in a word that one of the system's maps leads
// to.
WalkedWord rootWord(const ifs::AffineMap<3>& box, const SpaceView& view);
WalkedWord childWord(const WalkedWord& word, std::size_t index, const ifs::AffineMap<3>& map,
                     const SpaceView& view);
WalkedWord walkedTo(const ifs::Word& address, WalkedWord word, std::span<const ifs::AffineMap<3>> maps,
                    const SpaceView& view);
// Caches in `word` what its subwords need.
StraightWord straightened(WalkedWord& word, const SpaceView& view);

// The displayed word: an affine map of [−1, 1]³ to the coordinates of SpaceView::toPixels, as seen on the
// screen.
struct SeenWord {
    bool isBehind = false;      // true if all of it is nearer than the near plane or outside the clip
    bool isCut = false;         // true if part of it is outside the clip
    bool reachesEye = false;    // true if part of it is behind the near plane; then nothing else is known
    ifs::AffineMap<3> onScreen; // first-order map to pixels from the top left corner, and depth
    // Half extents of the box around the word; x and y include `miss`.
    ifs::Vector<3> half = ifs::Vector<3>::Zero();
    double miss = 0;  // error of the first-order map, in pixels
    double scale = 1; // screen pixels per pixel in the plane of the target

    double size() const; // size of the box in pixels
    bool meets(const RasterSize& size) const;
    double nearest() const { return onScreen.translation.z() - half.z(); }
    double farthest() const { return onScreen.translation.z() + half.z(); }
};
SeenWord seen(const ifs::AffineMap<3>& word, const SpaceView& view);
SeenWord seen(WalkedWord& word, const SpaceView& view);
// A cheaper bound from what is cached already: contained in a box that may be larger.
SeenWord glimpsed(WalkedWord& word, const SpaceView& view);

} // namespace attractor
