// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/colour/palette.h"
#include "attractor/light/tone_map16.h"

#include <cstdint>
#include <span>

namespace attractor {

// Lays a picture without a background over its shadow, with that opacity, and both over the background: in
// code values, as every viewer composites. 32-bit pixels are as in Frame::pixels, premultiplied.
struct ShadowLayer {
    double opacity = 0; // 0 … 1
    Rgba background;

    void putUnder(std::span<std::uint32_t> picture, std::span<const std::uint32_t> shadow) const;
    void putUnder(std::span<Rgba16> picture, std::span<const Rgba16> shadow) const;
};

} // namespace attractor
