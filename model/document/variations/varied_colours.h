// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "document/variations/chance.h"

namespace document {

// Mixes colours so that half-way looks half-way; exact at both ends.
attractor::Rgba mixedColour(const attractor::Rgba& from, const attractor::Rgba& to, double share);

// The palette, the plain colour and those of the maps in other hues, `strength` from 0 to 1; now and then
// another of the built-in palettes. The background, and what the colours stand for, stay.
void varyColours(Fractal& fractal, double strength, Chance& chance);

} // namespace document
