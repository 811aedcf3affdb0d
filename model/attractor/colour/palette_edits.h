// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/colour/palette.h"

#include <cstddef>

// Edits of a palette in the gradient editor. Every palette has at least two stops; the first and the last
// stay at 0 and 1.
namespace attractor {

// A new stop with the colour that is there already; returns its index, between the first and the last stop.
std::size_t addStop(Palette& palette, double position);
bool canMove(const Palette& palette, std::size_t stop); // true for inner stops, which alone can be removed
void moveStop(Palette& palette, std::size_t stop, double position); // clamped between its neighbours
void removeStop(Palette& palette, std::size_t stop);
void reverse(Palette& palette);
void distribute(Palette& palette); // puts stops at equal distances

// Turns the hue of every stop. Lightness in Oklab stays, and chroma as far as a screen shows it.
void turnHue(Palette& palette, double degrees);
// Rotates the palette: the colour at `offset` moves to the beginning, and the stops before it to the end. A
// whole number changes nothing.
void shift(Palette& palette, double offset);

} // namespace attractor
