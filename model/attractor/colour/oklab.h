// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/colour/palette.h"

namespace attractor {

// Colours in which equal distances look about equally large, and their opacity.
// Björn Ottosson, A perceptual color space for image processing (2020).
struct Oklab {
    double lightness, a, b, alpha;
};
Oklab oklab(const LinearColour& colour);
Rgba colourOf(const Oklab& lab); // the nearest in sRGB, channel by channel

} // namespace attractor
