// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/colour/palette.h"
#include "attractor/kernels/picture_mix.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace attractor {

// A picture and its halvings, averaged in linear light, down to a single pixel.
class MipPicture {
public:
    MipPicture() = default;
    // Pixels row by row from the top left, sRGB, not premultiplied: width·height of them, both positive.
    MipPicture(int width, int height, const std::vector<Rgba>& pixels);

    int width() const { return m_width; }
    int height() const { return m_height; }

    // The colour at (x, y) in pixels, with (0, 0) at the top left corner of the top left one, averaged over
    // about `area` pixels. Premultiplied; transparent outside.
    LinearColour at(double x, double y, double area) const;

    // The same for many places, in whole numbers: of places inside, four channels each.
    bool isInside(double x, double y) const { return x >= 0 && x <= m_width && y >= 0 && y <= m_height; }
    kernels::PicturePlace place(double x, double y, std::int32_t level) const {
        return {std::int64_t(x * unit), std::int64_t(y * unit), std::clamp(level, 0, m_lastLevel)};
    }
    void mix(std::span<const kernels::PicturePlace> places, std::span<std::int16_t> channels) const {
        kernels::mixPicture(m_channels.data(), m_levels.data(), places.data(), places.size(),
                            channels.data());
    }

private:
    static constexpr double unit = 1 << kernels::placeBits;

    LinearColour smooth(std::size_t level, double x, double y) const;
    std::int16_t* append(int columns, int rows); // makes room for one more level
    void halve();                                // halves the last level
    void repeatLast();                           // repeats the last pixel of each row, and the last row

    int m_width = 0, m_height = 0;
    std::int32_t m_lastLevel = 0; // same meaning as in kernels::PicturePlace
    std::vector<kernels::PictureLevel> m_levels;
    std::vector<std::int16_t> m_channels; // channels of all levels
};

// The level whose pixels are as large as `area`, as in kernels::PicturePlace, below 0 for less than a pixel:
// half the logarithm to base 2. Factors may be added up.
std::int32_t mipLevel(double area);

} // namespace attractor
