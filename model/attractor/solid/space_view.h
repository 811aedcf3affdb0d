// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/orbit_camera.h"
#include "ifs/system/affine_map.h"

namespace attractor {

// camera · cage in space. An affine map to pixels in the plane of the target: to the right and downwards from
// the middle of the picture, and away from the eye; and an eye, to which all of it shrinks.
// docs/mathematics.md, "Perspective".
struct SpaceView {
    ifs::AffineMap<3> toPixels;
    double eyeDistance = 0; // pixels; 0: orthographic
    RasterSize size;

    bool isPerspective() const { return eyeDistance > 0; }
};
SpaceView spaceView(const OrbitCamera& camera, const ifs::AffineMap<3>& cage);

// Points nearer to the eye than this share of its distance from the target are not drawn.
constexpr double nearestShare = 0x1p-10;

// What a word, an affine map of [−1, 1]³ to the coordinates of SpaceView::toPixels, shows on the screen.
struct SeenWord {
    bool isBehind = false;      // nearer than is drawn, all of it
    bool reachesEye = false;    // part of it is: nothing else is known
    ifs::AffineMap<3> onScreen; // to first order: pixels from the top left corner, and depth
    ifs::Vector<3> half;        // of the box around the word itself; x and y include `miss`
    double miss = 0;            // pixels by which the first-order map may be off
    double scale = 1;           // pixels of the screen for one in the plane of the target

    double size() const; // of the box in pixels
    bool meets(const RasterSize& size) const;
    double nearest() const { return onScreen.translation.z() - half.z(); }
    double farthest() const { return onScreen.translation.z() + half.z(); }
};
SeenWord seen(const ifs::AffineMap<3>& word, const SpaceView& view);

} // namespace attractor
