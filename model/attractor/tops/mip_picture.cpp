// SPDX-License-Identifier: MIT
#include "attractor/tops/mip_picture.h"

#include "attractor/arithmetic/arithmetic.h"
#include "attractor/colour/srgb_transfer.h"

#include <algorithm>
#include <array>
#include <bit>

namespace attractor {

namespace {

constexpr double one = 65535;

LinearColour mix(const LinearColour& a, const LinearColour& b, double share) {
    return {a.red + (b.red - a.red) * share, a.green + (b.green - a.green) * share,
            a.blue + (b.blue - a.blue) * share, a.alpha + (b.alpha - a.alpha) * share};
}

std::uint16_t rounded(double value) {
    return std::uint16_t(std::clamp(value * one + 0.5, 0.0, one));
}

// log₂ x for x ≥ 1 to 3·10⁻⁶, exact for powers of two: straight between 256 values for each of them.
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

} // namespace

MipPicture::MipPicture(int width, int height, std::vector<Rgba> pixels)
    : m_width(width), m_height(height), m_pixels(std::move(pixels)) {
    while (widthOf(m_levels.size()) > 1 || heightOf(m_levels.size()) > 1)
        m_levels.push_back(halved(m_levels.size()));
}

LinearColour MipPicture::pixel(std::size_t level, int column, int row) const {
    if (level == 0) {
        const Rgba& c = m_pixels[std::size_t(row) * std::size_t(m_width) + std::size_t(column)];
        const double alpha = c.alpha / 255.0;
        return {linearLight(c.red) * alpha, linearLight(c.green) * alpha, linearLight(c.blue) * alpha, alpha};
    }
    const Level& from = m_levels[level - 1];
    const std::uint16_t* c =
        from.channels.data() + 4 * (std::size_t(row) * std::size_t(from.width) + std::size_t(column));
    return {c[0] / one, c[1] / one, c[2] / one, c[3] / one};
}

// Of an odd number of columns or rows, the last is averaged with itself.
MipPicture::Level MipPicture::halved(std::size_t level) const {
    const int width = widthOf(level), height = heightOf(level);
    Level result{(width + 1) / 2, (height + 1) / 2, {}};
    result.channels.reserve(4 * std::size_t(result.width) * std::size_t(result.height));
    for (int row = 0; row < result.height; ++row)
        for (int column = 0; column < result.width; ++column) {
            const int right = std::min(2 * column + 1, width - 1), below = std::min(2 * row + 1, height - 1);
            const LinearColour upper =
                mix(pixel(level, 2 * column, 2 * row), pixel(level, right, 2 * row), 0.5);
            const LinearColour lower = mix(pixel(level, 2 * column, below), pixel(level, right, below), 0.5);
            const LinearColour mean = mix(upper, lower, 0.5);
            for (const double channel : {mean.red, mean.green, mean.blue, mean.alpha})
                result.channels.push_back(rounded(channel));
        }
    return result;
}

// Between the four nearest pixels.
LinearColour MipPicture::smooth(std::size_t level, double x, double y) const {
    const double lastColumn = widthOf(level) - 1, lastRow = heightOf(level) - 1;
    const double column = std::clamp(x - 0.5, 0.0, lastColumn), row = std::clamp(y - 0.5, 0.0, lastRow);
    const int left = int(column), top = int(row);
    const int right = std::min(left + 1, int(lastColumn)), bottom = std::min(top + 1, int(lastRow));
    const double across = column - left, down = row - top;
    if (level == 0)
        return mix(mix(pixel(level, left, top), pixel(level, right, top), across),
                   mix(pixel(level, left, bottom), pixel(level, right, bottom), across), down);
    const Level& from = m_levels[level - 1];
    const auto above = 4 * std::size_t(top) * std::size_t(from.width);
    const auto below = 4 * std::size_t(bottom) * std::size_t(from.width);
    const std::uint16_t* channels = from.channels.data();
    const std::uint16_t* corners[] = {channels + above + 4 * left, channels + above + 4 * right,
                                      channels + below + 4 * left, channels + below + 4 * right};
    const double weights[] = {(1 - across) * (1 - down) / one, across * (1 - down) / one,
                              (1 - across) * down / one, across * down / one};
    std::array<double, 4> sums{};
    for (std::size_t corner = 0; corner < 4; ++corner)
        for (std::size_t channel = 0; channel < 4; ++channel)
            sums[channel] += weights[corner] * corners[corner][channel];
    return {sums[0], sums[1], sums[2], sums[3]};
}

LinearColour MipPicture::at(double x, double y, double area) const {
    if (!(x >= 0 && x <= m_width && y >= 0 && y <= m_height)) return {0, 0, 0, 0};
    const double level = area > 1 ? std::min(binaryLogarithm(area) / 2, double(m_levels.size())) : 0;
    const auto fine = std::size_t(level);
    const auto at = [&](std::size_t k) {
        const double scale = 1 / double(std::uint64_t{1} << k);
        return smooth(k, x * scale, y * scale);
    };
    const LinearColour first = at(fine);
    return level > double(fine) ? mix(first, at(fine + 1), level - double(fine)) : first;
}

} // namespace attractor
