// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/colour/palette.h"

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
    MipPicture(int width, int height, std::vector<Rgba> pixels);

    int width() const { return m_width; }
    int height() const { return m_height; }

    // At (x, y) in pixels, (0, 0) the top left corner of the top left one, averaged over about `area` pixels.
    // Premultiplied by its opacity; nothing outside.
    LinearColour at(double x, double y, double area) const;

private:
    struct Level {
        int width = 0, height = 0;
        std::vector<std::uint16_t> channels; // red, green, blue, alpha: linear, premultiplied, 65535 is 1
    };
    LinearColour pixel(std::size_t level, int column, int row) const;
    LinearColour smooth(std::size_t level, double x, double y) const;
    Level halved(std::size_t level) const;
    int widthOf(std::size_t level) const { return level == 0 ? m_width : m_levels[level - 1].width; }
    int heightOf(std::size_t level) const { return level == 0 ? m_height : m_levels[level - 1].height; }

    int m_width = 0, m_height = 0;
    std::vector<Rgba> m_pixels;
    std::vector<Level> m_levels; // the first is half as large as the picture
};

} // namespace attractor
