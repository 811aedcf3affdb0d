// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/light/tone_map16.h"

#include <cstdint>
#include <span>

namespace attractor {

// What a picture drawn with side × side pixels for each of its own shows: their mean in linear light,
// weighted by opacity. `fine` holds whole rows of side · width pixels, side rows for each of `pixels`.
void averagePixels(std::span<const std::uint32_t> fine, int side, int width, std::span<std::uint32_t> pixels);
void averagePixels(std::span<const Rgba16> fine, int side, int width, std::span<Rgba16> pixels);

} // namespace attractor
