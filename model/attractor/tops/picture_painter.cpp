// SPDX-License-Identifier: MIT
#include "attractor/tops/picture_painter.h"

#include "attractor/colour/srgb_transfer.h"

#include <algorithm>

namespace attractor {

namespace {

using kernels::fullChannel;

// Straight sRGB under a premultiplied colour in linear light, premultiplied again as codes.
std::uint32_t packed(const LinearColour& over, const LinearColour& under) {
    const double rest = (1 - over.alpha) * under.alpha, alpha = over.alpha + rest;
    if (!(alpha > 0)) return 0;
    const auto opacity = std::uint32_t(std::clamp(alpha, 0.0, 1.0) * 255 + 0.5);
    const auto channel = [&](double above, double below) {
        const double light = std::clamp((above + rest * below) / alpha, 0.0, 1.0);
        return (std::uint32_t(encoded(light)) * opacity + 127) / 255;
    };
    return opacity << 24 | channel(over.red, under.red) << 16 | channel(over.green, under.green) << 8 |
           channel(over.blue, under.blue);
}

using Codes = std::array<std::uint8_t, fullChannel + 1>;

const Codes& codes() { // codes of channels
    static const Codes table = [] {
        Codes values{};
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = encoded(double(i) / fullChannel);
        return values;
    }();
    return table;
}

} // namespace

PicturePainter::PicturePainter(const MipPicture& picture, const Rgba& background,
                               std::span<std::uint32_t> pixels)
    : m_picture(picture),
      m_under(linearColour(background)),
      m_empty(packed({0, 0, 0, 0}, m_under)),
      m_pixels(pixels) {}

void PicturePainter::finish() {
    const Codes& table = codes();
    std::array<std::int16_t, 4 * together> mixed;
    m_picture.mix(std::span(m_places).first(m_waiting), mixed);
    const std::int16_t* c = mixed.data();
    for (std::size_t k = 0; k < m_waiting; ++k, c += 4) {
        constexpr double one = fullChannel;
        m_pixels[m_targets[k]] =
            c[3] == fullChannel ? 0xFF000000U | std::uint32_t(table[std::size_t(c[0])]) << 16 |
                                      std::uint32_t(table[std::size_t(c[1])]) << 8 | table[std::size_t(c[2])]
                                : packed({c[0] / one, c[1] / one, c[2] / one, c[3] / one}, m_under);
    }
    m_waiting = 0;
}

} // namespace attractor
