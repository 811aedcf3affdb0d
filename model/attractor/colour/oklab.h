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
LinearColour lightOf(const Oklab& lab); // channels outside 0 … 1 for colours that no screen shows
Rgba colourOf(const Oklab& lab);        // nearest in sRGB, channel by channel
Rgba nearestShown(const Oklab& lab);    // same lightness and hue, with as much of the chroma as sRGB has

} // namespace attractor
