// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/light/solid_appearance.h"

#include <cstdint>
#include <vector>

namespace attractor {

constexpr int tintCount = 256; // number of tints of a coloured solid

// The colours of a solid from shade to light, for each of its tints.
struct SolidRamp {
    int levels = 1; // number of light levels for each tint, from darkness to 1
    std::vector<LinearColour> tints;
    std::vector<std::uint32_t> pixels; // 0xFFRRGGBB; all levels of the first tint, then of the second …
};

SolidRamp solidRamp(const SolidAppearance& appearance);

// The colour of a tint under a light of 0 … 1, for Stone and Ink.
LinearColour litColour(Look look, const LinearColour& tint, double light);

} // namespace attractor
