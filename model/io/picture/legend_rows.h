// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/light/tone_map16.h"

#include <QImage>

#include <cstddef>
#include <span>
#include <vector>

namespace io {

template <class Pixel>
inline constexpr QImage::Format imageFormat = sizeof(Pixel) == sizeof(attractor::Rgba16)
                                                  ? QImage::Format_RGBA64
                                                  : QImage::Format_ARGB32_Premultiplied;

// Rows of the picture, the first of which is `row`, with those of the legend, which has imageFormat<Pixel>.
template <class Pixel>
std::span<const Pixel> withLegend(std::span<const Pixel> pixels, std::size_t width, const QImage& legend,
                                  int row, std::vector<Pixel>& memory) {
    if (legend.isNull()) return pixels;
    memory.clear();
    for (std::size_t at = 0; at < pixels.size(); at += width, ++row) {
        const std::span<const Pixel> left = pixels.subspan(at, width);
        const auto* right = reinterpret_cast<const Pixel*>(legend.constScanLine(row));
        memory.insert(memory.end(), left.begin(), left.end());
        memory.insert(memory.end(), right, right + legend.width());
    }
    return memory;
}

} // namespace io
