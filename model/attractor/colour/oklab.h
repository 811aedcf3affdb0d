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
LinearColour lightOf(const Oklab& lab); // channels below 0 or above 1 where no screen shows it
Rgba colourOf(const Oklab& lab);        // the nearest in sRGB, channel by channel
Rgba nearestShown(const Oklab& lab);    // the same lightness and hue, with as much of the chroma as sRGB has

} // namespace attractor
