// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/light/tone_map16.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace attractor {

// Downsamples a picture drawn with side × side pixels for each of `pixels`: their mean in linear light,
// weighted by opacity. `fine` holds whole rows of side · width pixels, side rows for each row of `pixels`.
void averagePixels(std::span<const std::uint32_t> fine, int side, int width, std::span<std::uint32_t> pixels);
void averagePixels(std::span<const Rgba16> fine, int side, int width, std::span<Rgba16> pixels);

// Light that adds up, linear and weighted by opacity.
struct LightSum {
    double alpha = 0;
    std::array<double, 3> light{}; // premultiplied by alpha
};

// The mean of several pictures of one size, in linear light and weighted by opacity, as seen through an open
// shutter. Pixels that never change keep their bytes.
template <class Pixel> class PictureAverage { // std::uint32_t or Rgba16
public:
    void add(std::span<const Pixel> picture);
    void mean(std::span<Pixel> pixels) const; // same size as the pictures, of which there is at least one

private:
    std::vector<LightSum> m_sums;
    int m_pictures = 0;
};
extern template class PictureAverage<std::uint32_t>;
extern template class PictureAverage<Rgba16>;

} // namespace attractor
