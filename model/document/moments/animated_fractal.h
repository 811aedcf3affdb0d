// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "ifs/existence/attractor_existence.h"

#include <cstddef>
#include <optional>
#include <set>
#include <stop_token>
#include <vector>

// Entries whose shape has an animation, and their states at a moment.
namespace document {

// Properties that animations of both dimensions have in common.
struct AnimationFacts {
    animation::FrameRate rate;
    int length = 0; // number of frames
    animation::Loop loop = animation::Loop::Off;
    int tracks = 0;
    std::size_t motions = 0;
    // Frames with another camera than the moment before, as where an endless zoom jumps back.
    std::vector<int> cuts{};
};
std::optional<AnimationFacts> animationFacts(const Fractal& fractal); // nullopt: no motion

// An entry at a moment: an ordinary fractal without an animation, and the camera if keys move it.
struct AnimatedFrame {
    Fractal fractal;
    std::optional<attractor::View> view{};
    std::optional<attractor::OrbitCamera> camera{}; // entries in space only; its size is meaningless
    std::vector<animation::CameraTurn> orbit{};     // turns of a camera in space, from animation::orbited()
};

// A fractal that is not animated is the same at every moment.
AnimatedFrame frameAt(const Fractal& fractal, const animation::Moment& moment);

// The cage of an entry that stores none, to be kept at all moments and during a gesture; none where it takes
// long to be found.
LastingCage lastingCage(const Fractal& entry);

// The look as a key stores it; in space with the appearance there.
animation::Look lookOf(const Fractal& fractal);
Fractal withLook(Fractal fractal, const animation::Look& look);

// Evenly spaced moments from the first frame to the last one; `count` ≥ 2.
std::vector<animation::Moment> moments(const AnimationFacts& facts, int count);

// None, Empty or Undecided where no attractor is certain at the moment; nullopt where one is.
std::optional<ifs::Verdict> lossAt(const Fractal& fractal, const animation::Moment& moment);

// The frames at which an attractor is looked for: those of the keys of maps, and all others; of more than
// 240, or where the maps are many, evenly chosen ones.
std::set<int> framesToTry(const Fractal& fractal);
std::set<int> keyFramesOfMaps(const Fractal& fractal);

// The first of these frames, and of 33 evenly spaced moments, at which no attractor is certain. Where the
// keys have a common norm and no motion follows, none fails, and nothing is tried. What is returned once
// stopped means nothing.
struct MomentWithoutAttractor {
    animation::Moment moment;
    ifs::Verdict verdict; // None, Empty or Undecided
};
std::optional<MomentWithoutAttractor> firstWithoutAttractor(const Fractal& fractal,
                                                            const std::stop_token& stop = {});

// Returns true if there is such a moment; nullopt when stopped before that is known.
std::optional<bool> losesAttractor(const Fractal& fractal, const std::stop_token& stop);

// The same with this motion as strong as it is, or else as strong as leaves an attractor at all these
// moments, to a thousandth.
Fractal withSafeStrength(const Fractal& fractal, std::size_t motion);
std::optional<Fractal> withSafeStrength(const Fractal& fractal, std::size_t motion,
                                        const std::stop_token& stop); // nullopt if stopped

} // namespace document
