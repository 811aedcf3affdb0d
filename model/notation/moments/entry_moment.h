// SPDX-License-Identifier: MIT
#pragma once

#include "animation/animation.h"
#include "notation/value/entry.h"

#include <optional>

// Entries that move, and what they are at a moment, as document/moments has it for the window.
namespace notation {

// Whether the lines of an animation are among those that the entry keeps, understood or not.
bool isAnimated(const Entry& entry);

// The last animation of the entry that is understood and fits its maps and its cage; nullopt where there is
// none.
template <int Dim> std::optional<animation::Animation<Dim>> animationOf(const Entry& entry);

struct AnimationFacts {
    animation::FrameRate rate;
    int length = 0; // frames
    animation::Loop loop = animation::Loop::Off;
};
std::optional<AnimationFacts> animationFacts(const Entry& entry);

// The entry as it is at a moment, with keys and motions applied and without the lines of the animation. The
// camera, which is no part of an entry, stays out. An entry without an animation is the same at every moment.
Entry atMoment(Entry entry, const animation::Moment& moment);

} // namespace notation
