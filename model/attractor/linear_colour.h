// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/palette.h"

namespace attractor {

// Linear light and opacity, 0 … 1, unrounded.
struct LinearColour {
    double red = 0;
    double green = 0;
    double blue = 0;
    double alpha = 1;
};
LinearColour linearColour(const Rgba& colour);
LinearColour linearColourAt(const Palette& palette, double position); // colourAt() before it is rounded

} // namespace attractor
