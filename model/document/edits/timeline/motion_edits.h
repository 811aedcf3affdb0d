// SPDX-License-Identifier: MIT
#pragma once

#include "animation/motions/motion_presets.h"
#include "document/fractal/fractal.h"

#include <optional>
#include <stop_token>

// Loops in one step: motions, and a camera that never arrives. All take an entry with its animation, if it
// has one, and add to it. What may take long, as of many maps, returns nullopt soon after it is stopped.
namespace document {

// Adds a sway about the lowest point on the screen, as strong as leaves an attractor at all times. nullopt if
// the entry holds no maps, as for all of these functions.
std::optional<Fractal> withWind(const Fractal& entry, const animation::SwayPreset& preset,
                                const std::stop_token& stop = {});
// Adds one turn about the middle to all maps; if that would lose the attractor, to those that can turn.
// nullopt if none can.
std::optional<Fractal> withTurn(const Fractal& entry, const std::stop_token& stop = {});
// The picture, or the camera in space, goes round once, about the middle of the attractor: centreOfPicture().
// An entry that has no animation yet begins with one of five seconds. `axis` is that in space.
std::optional<Fractal> withOrbit(const Fractal& entry, const ifs::Vector<3>& axis = ifs::Vector<3>::UnitY());
// Makes all maps swell and shrink by up to a tenth, as far as leaves an attractor at all times.
std::optional<Fractal> withBreathing(const Fractal& entry, const std::stop_token& stop = {});
// The palette goes round.
std::optional<Fractal> withPaletteCycle(const Fractal& entry);

// Camera keys at both ends from a view to its image under a similarity among the maps of what is displayed,
// or under its square if it mirrors: as one piece is a small copy of the whole, the last frame is the first.
// nullopt unless the entry is in the plane and has such a piece, with all others certainly out of sight at
// the end. `aspect` is that of the picture, width by height, ≥ 1 or below. docs/mathematics.md, "Animation".
std::optional<Fractal> withEndlessZoom(const Fractal& entry, double aspect, attractor::YAxis yAxis,
                                       const std::stop_token& stop = {});

} // namespace document
