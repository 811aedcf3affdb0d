// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/colour/palette.h"

#include <cstddef>
#include <span>

namespace attractor {

inline constexpr std::size_t maxPictureColours = 64;

// The colours that represent a picture best: k-means in Oklab, k from 2 to maxPictureColours, fewer where the
// picture has fewer; always two stops at least. Transparent pixels do not count. The same for the same
// pixels. From dark to light, at equal distances.
Palette paletteOfPicture(std::span<const Rgba> pixels, std::size_t colours);
// The palette of pixels along a line, each colour where its pixels are on average.
Palette paletteAlongLine(std::span<const Rgba> pixels, std::size_t colours);

} // namespace attractor
