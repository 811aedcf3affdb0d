// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace attractor::kernels {

constexpr int channelBits = 15;
constexpr std::int32_t fullChannel = (1 << channelBits) - 1;

// A picture or one of its halvings: red, green, blue and alpha, premultiplied, in linear light of 0 to
// fullChannel, row by row. The last pixel of a row stands there twice, and so does the last row.
struct PictureLevel {
    std::size_t first = 0; // index of its first channel among those of all levels
    std::int32_t columns = 1;
    std::int32_t rows = 1;
};

// A place in a picture at which it is sampled: fixed-point coordinates with `placeBits` fractional bits, in
// pixels from the top left corner of the first level, inside of the picture; and the two levels between which
// it lies.
constexpr int placeBits = 15;
struct PicturePlace {
    std::int64_t x = 0, y = 0;
    std::int32_t level = 0;
};

// The four channels of each place, between the four nearest pixels of the two levels. Whole numbers: the same
// for every instruction set.
void mixPicture(const std::int16_t* channels, const PictureLevel* levels, const PicturePlace* places,
                std::size_t count, std::int16_t* mixed);

} // namespace attractor::kernels
