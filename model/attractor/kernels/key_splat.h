// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace attractor::kernels {

inline constexpr std::uint32_t noKey = 0xFFFFFFFF;

// The smallest key that has fallen into each pixel of some rows of a picture.
struct KeyRows {
    int width = 0;
    int firstRow = 0;
    int endRow = 0;
    // Row by row, and a cell behind them for what falls outside, in which no key is smaller.
    std::vector<std::uint32_t> keys;

    void reset(int columns, int first, int end); // empty
};

// A word as an affine map from the coordinates of the samples to pixels.
struct KeyWord {
    float xx = 0, xy = 0, yx = 0, yy = 0, x = 0, y = 0;
    std::uint32_t firstKey = 0; // of its first sample; the others follow
};

// The minimum fold of the samples of a word. The arrays are read up to a multiple of 16; the points behind
// `count` must be copies of the last one. The same bits for every instruction set.
void addKeys(const KeyWord& word, const float* x, const float* y, std::size_t count, KeyRows& rows);

} // namespace attractor::kernels
