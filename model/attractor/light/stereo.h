// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/light/tone_map16.h"
#include "ifs/names.h"

#include <array>
#include <cstdint>
#include <vector>

namespace attractor {

enum class Stereo {
    None,
    SideBySide, // left eye's picture to the left
    Anaglyph,   // red filter before the left eye, cyan before the right one
};

// Number of single pictures side by side in a stereo picture.
constexpr int picturesAcross(Stereo stereo) {
    return stereo == Stereo::SideBySide ? 2 : 1;
}

// Joins the pictures of both eyes, each `width` pixels wide and with equally many pixels, into one. Pixels
// are 0xAARRGGBB, premultiplied, or Rgba16. docs/mathematics.md, "Stereo".
std::vector<std::uint32_t> joined(Stereo stereo, const std::vector<std::uint32_t>& left,
                                  const std::vector<std::uint32_t>& right, int width);
std::vector<Rgba16> joined(Stereo stereo, const std::vector<Rgba16>& left, const std::vector<Rgba16>& right,
                           int width);

} // namespace attractor

template <>
inline constexpr auto ifs::names<attractor::Stereo> = std::to_array<ifs::Named<attractor::Stereo>>({
    {attractor::Stereo::None, "none"},
    {attractor::Stereo::SideBySide, "side-by-side"},
    {attractor::Stereo::Anaglyph, "anaglyph"},
});
