// SPDX-License-Identifier: MIT
#pragma once

#include "animation/keys/moment.h"
#include "attractor/request/render_request.h"
#include "document/moments/animated_fractal.h"

#include <vector>

// Exposure of a frame of an animation: the time for which the shutter is open, and the brightness. Both are
// functions of the animation and the frame, so that a frame drawn alone is that of the sequence.
// docs/mathematics.md, "Shutter".
namespace document {

// Time for which a shutter is open, in thousandths of a degree: 360° are the time from one frame to the next.
// 0: the moment alone.
using ShutterAngle = int;
constexpr ShutterAngle maxShutterAngle = 360'000;

// The middles of `count` equal parts of the time for which the shutter is open around a frame, within the
// animation and on one side of a cut of its camera; and their beginnings and ends, one more.
std::vector<animation::Moment> shutterMiddles(const AnimationFacts& facts, int frame, ShutterAngle angle,
                                              int count);
std::vector<animation::Moment> shutterEdges(const AnimationFacts& facts, int frame, ShutterAngle angle,
                                            int count);

// The moments between which exposures are interpolated: frame 0 and the last one, all keys, eight moments a
// length if there are motions, the last frame before a keyed value jumps, and the middles between all of
// these. Ascending; at most 255.
std::vector<animation::Moment> exposurePilots(const Fractal& fractal);

// A moment, folded, between two neighbours of these pilots.
struct BetweenPilots {
    std::size_t before = 0; // index of the pilot before
    std::size_t after = 0;  // index of the pilot after; equal to `before` at a pilot
    double share = 0;
};
BetweenPilots betweenPilots(const std::vector<animation::Moment>& pilots, const animation::Moment& moment);

// Geometrically; `from` at 0. The same bits on every machine.
attractor::Exposure interpolated(const attractor::Exposure& from, const attractor::Exposure& to,
                                 double share);

} // namespace document
