// SPDX-License-Identifier: MIT
#include "attractor/tops/mip_picture.h"

#include "attractor/arithmetic/arithmetic.h"
#include "attractor/colour/srgb_transfer.h"

#include <array>
#include <bit>
#include <cmath>

namespace attractor {

namespace {

using kernels::fullChannel;
using kernels::PictureLevel;

LinearColour mix(const LinearColour& a, const LinearColour& b, double share) {
    return {a.red + (b.red - a.red) * share, a.green + (b.green - a.green) * share,
            a.blue + (b.blue - a.blue) * share, a.alpha + (b.alpha - a.alpha) * share};
}

std::int16_t rounded(double value) {
    return std::int16_t(value * fullChannel + 0.5);
}

// log₂ x for x > 0 to 3·10⁻⁶, exact for powers of two: straight between 256 values for each of them.
double binaryLogarithm(double x) {
    constexpr int tableBits = 8, mantissaBits = 52;
    static const auto table = [] {
        std::array<double, (1U << tableBits) + 1> values{};
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = naturalLogarithm(1 + double(i) / (1U << tableBits)) / naturalLogarithm(2);
        return values;
    }();
    const auto bits = std::bit_cast<std::uint64_t>(x);
    constexpr int restBits = mantissaBits - tableBits;
    const std::size_t index = bits >> restBits & ((1U << tableBits) - 1);
    const double share = double(bits & ((std::uint64_t{1} << restBits) - 1)) * 0x1p-44;
    return int(bits >> mantissaBits) - 1023 + table[index] + (table[index + 1] - table[index]) * share;
}

std::size_t stride(const PictureLevel& level) {
    return 4 * (std::size_t(level.columns) + 1);
}

} // namespace

MipPicture::MipPicture(int width, int height, const std::vector<Rgba>& pixels)
    : m_width(width), m_height(height) {
    std::array<double, 256> light{};
    for (std::size_t code = 0; code < light.size(); ++code)
        light[code] = linearLight(std::uint8_t(code));
    const auto columns = std::size_t(width), lines = std::size_t(height);
    m_channels.reserve(6 * columns * lines + 16 * (columns + lines) + 512); // a third more than the picture
    std::int16_t* to = append(width, height);
    const Rgba* from = pixels.data();
    for (int row = 0; row < height; ++row, to += 4)
        for (int column = 0; column < width; ++column, ++from, to += 4) {
            const double alpha = from->alpha / 255.0;
            to[0] = rounded(light[from->red] * alpha);
            to[1] = rounded(light[from->green] * alpha);
            to[2] = rounded(light[from->blue] * alpha);
            to[3] = rounded(alpha);
        }
    repeatLast();
    while (m_levels.back().columns > 1 || m_levels.back().rows > 1)
        halve();
    m_lastLevel = std::int32_t(m_levels.size() - 1) << kernels::placeBits;
}

std::int16_t* MipPicture::append(int columns, int rows) {
    m_levels.push_back({m_channels.size(), columns, rows});
    m_channels.resize(m_channels.size() + stride(m_levels.back()) * (std::size_t(rows) + 1));
    return m_channels.data() + m_levels.back().first;
}

void MipPicture::repeatLast() {
    const PictureLevel& level = m_levels.back();
    std::int16_t* row = m_channels.data() + level.first;
    for (int k = 0; k < level.rows; ++k, row += stride(level))
        std::copy_n(row + stride(level) - 8, 4, row + stride(level) - 4);
    std::copy_n(row - stride(level), stride(level), row);
}

// Halves both sides; the last of an odd number of columns or rows is averaged with itself.
void MipPicture::halve() {
    const PictureLevel from = m_levels.back();
    const int columns = (from.columns + 1) / 2, rows = (from.rows + 1) / 2;
    std::int16_t* to = append(columns, rows);
    const std::int16_t* upper = m_channels.data() + from.first;
    for (int row = 0; row < rows; ++row, upper += 2 * stride(from), to += 4) {
        const std::int16_t* lower = upper + stride(from);
        for (std::size_t k = 0; k < 8 * std::size_t(columns); k += 8)
            for (std::size_t c = k; c < k + 4; ++c)
                *to++ = std::int16_t((upper[c] + upper[c + 4] + lower[c] + lower[c + 4] + 2) / 4);
    }
    repeatLast();
}

// Interpolates the four nearest pixels.
LinearColour MipPicture::smooth(std::size_t level, double x, double y) const {
    const PictureLevel& from = m_levels[level];
    const double column = std::clamp(x - 0.5, 0.0, double(from.columns - 1));
    const double row = std::clamp(y - 0.5, 0.0, double(from.rows - 1));
    const auto left = std::size_t(column), top = std::size_t(row);
    const double across = column - double(left), down = row - double(top);
    const std::int16_t* upper = m_channels.data() + from.first + top * stride(from) + 4 * left;
    const auto pixel = [](const std::int16_t* c) {
        constexpr double one = fullChannel;
        return LinearColour{c[0] / one, c[1] / one, c[2] / one, c[3] / one};
    };
    const std::int16_t* lower = upper + stride(from);
    return attractor::mix(attractor::mix(pixel(upper), pixel(upper + 4), across),
                          attractor::mix(pixel(lower), pixel(lower + 4), across), down);
}

LinearColour MipPicture::at(double x, double y, double area) const {
    if (!isInside(x, y)) return {0, 0, 0, 0};
    const double level = area > 1 ? std::min(binaryLogarithm(area) / 2, double(m_levels.size() - 1)) : 0;
    const auto fine = std::size_t(level);
    const auto at = [&](std::size_t k) {
        const double scale = 1 / double(std::uint64_t{1} << k);
        return smooth(k, x * scale, y * scale);
    };
    const LinearColour first = at(fine);
    return level > double(fine) ? attractor::mix(first, at(fine + 1), level - double(fine)) : first;
}

std::int32_t mipLevel(double area) {
    constexpr std::int32_t leastLevel = -(1 << 25); // below the level of any number
    if (!(area > 0)) return leastLevel;
    return std::int32_t(std::floor(binaryLogarithm(area) * (1 << (kernels::placeBits - 1)) + 0.5));
}

} // namespace attractor
