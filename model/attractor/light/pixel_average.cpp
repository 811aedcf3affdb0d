// SPDX-License-Identifier: MIT
#include "attractor/light/pixel_average.h"

#include "attractor/colour/srgb_transfer.h"

#include <algorithm>

namespace attractor {

namespace {

using Sum = LightSum;

constexpr int shifts[] = {16, 8, 0};

void add(Sum& sum, std::uint32_t pixel) {
    const std::uint32_t alpha = pixel >> 24;
    if (alpha == 0) return;
    sum.alpha += alpha / 255.0;
    for (std::size_t c = 0; c < 3; ++c) {
        const std::uint32_t code = pixel >> shifts[c] & 255U;
        const double light = alpha == 255 ? linearLight(static_cast<std::uint8_t>(code))
                                          : linearFromEncoded(static_cast<double>(code) / alpha);
        sum.light[c] += light * alpha / 255.0;
    }
}

void add(Sum& sum, const Rgba16& pixel) {
    const double alpha = pixel.alpha / 65535.0;
    sum.alpha += alpha;
    const std::uint16_t codes[] = {pixel.red, pixel.green, pixel.blue};
    for (std::size_t c = 0; c < 3; ++c)
        sum.light[c] += alpha * linearFromEncoded(codes[c] / 65535.0);
}

void store(const Sum& sum, int count, std::uint32_t& pixel) {
    pixel = 0;
    if (!(sum.alpha > 0)) return;
    const double alpha = sum.alpha / count;
    pixel = static_cast<std::uint32_t>(255 * alpha + 0.5) << 24;
    for (std::size_t c = 0; c < 3; ++c) {
        const double code = 255 * encodedFromLinear(std::min(sum.light[c] / sum.alpha, 1.0));
        const auto channel = static_cast<std::uint32_t>(alpha * code + 0.5);
        pixel |= std::min(channel, pixel >> 24) << shifts[c];
    }
}

void store(const Sum& sum, int count, Rgba16& pixel) {
    pixel = {};
    if (!(sum.alpha > 0)) return;
    std::uint16_t* const codes[] = {&pixel.red, &pixel.green, &pixel.blue};
    for (std::size_t c = 0; c < 3; ++c)
        *codes[c] = static_cast<std::uint16_t>(
            65535 * encodedFromLinear(std::min(sum.light[c] / sum.alpha, 1.0)) + 0.5);
    pixel.alpha = static_cast<std::uint16_t>(65535 * (sum.alpha / count) + 0.5);
}

template <class Pixel>
void average(std::span<const Pixel> fine, int side, int width, std::span<Pixel> pixels) {
    const auto across = static_cast<std::size_t>(side);
    const std::size_t fineWidth = across * static_cast<std::size_t>(width);
    for (std::size_t k = 0; k < pixels.size(); ++k) {
        const std::size_t row = k / static_cast<std::size_t>(width),
                          column = k % static_cast<std::size_t>(width);
        const Pixel* const first = fine.data() + row * across * fineWidth + column * across;
        bool same = true;
        for (std::size_t i = 0; i < across * across && same; ++i)
            same = first[i / across * fineWidth + i % across] == *first;
        if (same) {
            pixels[k] = *first;
            continue;
        }
        Sum sum;
        for (std::size_t i = 0; i < across * across; ++i)
            add(sum, first[i / across * fineWidth + i % across]);
        store(sum, side * side, pixels[k]);
    }
}

} // namespace

void averagePixels(std::span<const std::uint32_t> fine, int side, int width,
                   std::span<std::uint32_t> pixels) {
    average(fine, side, width, pixels);
}

void averagePixels(std::span<const Rgba16> fine, int side, int width, std::span<Rgba16> pixels) {
    average(fine, side, width, pixels);
}

template <class Pixel> void PictureAverage<Pixel>::add(std::span<const Pixel> picture) {
    m_sums.resize(picture.size());
    for (std::size_t k = 0; k < picture.size(); ++k)
        attractor::add(m_sums[k], picture[k]);
    ++m_pictures;
}

template <class Pixel> void PictureAverage<Pixel>::mean(std::span<Pixel> pixels) const {
    for (std::size_t k = 0; k < pixels.size(); ++k)
        store(m_sums[k], m_pictures, pixels[k]);
}

template class PictureAverage<std::uint32_t>;
template class PictureAverage<Rgba16>;

} // namespace attractor
