// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace attractor::kernels {

inline constexpr std::uint32_t noKey = 0xFFFFFFFF;

// Keys in some rows of a picture, row by row.
struct KeyRows {
    int width = 0;
    int firstRow = 0;
    int endRow = 0;
    std::span<std::uint32_t> keys; // one for each pixel; at least one
};

// A word as an affine map from the coordinates of the samples to pixels.
struct KeyWord {
    float xx = 0, xy = 0, yx = 0, yy = 0, x = 0, y = 0;
    std::uint32_t firstKey = 0; // key of its first sample; the others follow
};

// Inside: all samples of the word are known to fall into the rows.
enum class KeyReach { Inside, Across };

// Writes the keys of the samples of a word over earlier ones, the largest first, so that of those in a pixel
// the smallest stays. The arrays are read up to a multiple of 16; the points behind `count` must be copies of
// the last one. The same bits for every instruction set.
void putKeys(const KeyWord& word, KeyReach reach, const float* x, const float* y, std::size_t count,
             const KeyRows& rows);

} // namespace attractor::kernels
