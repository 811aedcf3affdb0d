// SPDX-License-Identifier: MIT
#pragma once

#include "animation/keys/keys.h"
#include "animation/motions/motion.h"
#include "animation/paths/cage_path.h"
#include "animation/paths/camera_path.h"
#include "animation/paths/look_path.h"
#include "animation/paths/map_path.h"

#include <optional>
#include <vector>

// Fractals that move. An animation is a value, and so is its state at a moment: code that draws, exports or
// analyses a picture need not know that it is one of many. docs/mathematics.md, "Animation".
namespace animation {

// A branch, by the ids of the maps of its address, that is shown elsewhere.
template <int Dim> struct BranchPose {
    std::vector<ifs::MapId> word;
    ifs::AffineMap<Dim> change;

    friend bool operator==(const BranchPose&, const BranchPose&) = default;
};

// The values that an animation can move, at one moment; or at rest, before it has moved any.
template <int Dim> struct Pose {
    ifs::IteratedFunctionSystem<Dim> system;
    std::optional<ifs::ControlCage<Dim>> cage{};
    std::vector<BranchPose<Dim>> moved{};
    attractor::Appearance appearance{};
    std::optional<CameraPose<Dim>> camera{}; // nullopt: the keys set no camera
    std::vector<CameraTurn> orbit{};         // turns of a camera in space, from orbited()
    attractor::SpaceAppearance inSpace{};
};

template <int Dim> struct MapTrack {
    ifs::MapId map = ifs::MapId::None;
    Keys<MapPose<Dim>> keys;

    friend bool operator==(const MapTrack&, const MapTrack&) = default;
};

template <int Dim> struct BranchTrack {
    std::vector<ifs::MapId> word;
    Keys<ifs::AffineMap<Dim>> keys;

    friend bool operator==(const BranchTrack&, const BranchTrack&) = default;
};

struct FrameRate {
    int frames = 24;
    int seconds = 1;

    friend bool operator==(const FrameRate&, const FrameRate&) = default;
};

template <int Dim> struct Animation {
    // Defined in one source, because many files copy animations.
    Animation();
    Animation(const Animation& other);
    Animation(Animation&& other) noexcept;
    Animation& operator=(const Animation& other);
    Animation& operator=(Animation&& other) noexcept;
    ~Animation();

    FrameRate rate;
    int length = 48; // frames, 1 … maxLength; keys lie at 0 … length
    Loop loop = Loop::Off;
    // The point whose images under the maps move straight; nullopt: the centre of the cage at rest, or
    // without a cage that of the fixed points.
    std::optional<ifs::Vector<Dim>> reference{};
    // The tracks. One without keys is still, and not listed.
    Keys<CagePose<Dim>> cage{}; // positions, one for each vertex of the cage
    std::vector<MapTrack<Dim>> maps{};
    std::vector<BranchTrack<Dim>> branches{};
    Keys<Look> look{};
    Keys<CameraPose<Dim>> camera{};
    std::vector<Motion<Dim>> motions{}; // applied after the keys, in this order

    // The pose at a moment: first the keys are applied, then the motions; values that nothing moves come from
    // `still`. Keys of maps that the system lacks, and cage keys with another number of vertices, have no
    // effect.
    Pose<Dim> at(const Moment& moment, Pose<Dim> still) const;

    friend bool operator==(const Animation&, const Animation&) = default;
};

template <int Dim> int trackCount(const Animation<Dim>& animation);

// Returns true if every number is finite and in its range, keys are in order and within the length, and no
// track is empty or listed twice.
template <int Dim> bool isValid(const Animation<Dim>& animation);

// The norm in which all codes along the keys contract, together with the maps that stay; nullopt where none
// is known: then some moment in between may have no attractor.
template <int Dim>
std::optional<CommonNorm<Dim>> commonNorm(const Animation<Dim>& animation,
                                          const ifs::IteratedFunctionSystem<Dim>& still);

} // namespace animation
