// SPDX-License-Identifier: MIT
#include "attractor/light/surface_rows.h"

#include <algorithm>
#include <cmath>

namespace attractor {

namespace {

constexpr int reach = 13;  // rows below that influence a row: a radius of 9 plus 4 for the minima
constexpr int spread = 4;  // columns beyond a window that influence its minima
constexpr int margin = 32; // cells beside a row: more than any step, and a whole vector

// Pixels of depth for one step of the code. A raster without a finite range, or a pixel without a finite
// size, is flat.
double pixelsPerCode(const DepthRaster& raster, double unitsPerPixel) {
    const double pixels = (raster.far - raster.near) / unitsPerPixel / maxDepthCode;
    return std::isfinite(pixels) && pixels > 0 ? pixels : 0;
}

kernels::OcclusionRadius occlusionAt(std::size_t k, const Occlusion& occlusion, double pixelsPerCode) {
    const double pixels = occlusion.saturation * Occlusion::radii[k];
    const double codes = std::max(1.0, pixels / pixelsPerCode); // infinite for a flat picture
    return {{},
            codes < maxDepthCode ? static_cast<std::int32_t>(codes + 0.5)
                                 : static_cast<std::int32_t>(maxDepthCode),
            static_cast<float>(occlusion.strength * occlusion.shares[k] / (8 * codes))};
}

} // namespace

SurfaceRows::SurfaceRows(const DepthRaster& raster, double unitsPerPixel, const Occlusion& occlusion,
                         int firstRow)
    : m_raster(raster), m_row(firstRow), m_loaded(firstRow - reach), m_first(raster.width), m_end(0) {
    const double scale = pixelsPerCode(raster, unitsPerPixel);
    m_pixelsPerCode = static_cast<float>(scale);
    for (std::size_t k = 0; k < m_radii.size(); ++k)
        m_radii[k] = occlusionAt(k, occlusion, scale);
    const auto stride = static_cast<std::size_t>(raster.width + 2 * margin);
    m_codes.resize(stride);
    m_three.resize(stride);
    m_square.resize(stride);
    m_nine.resize(stride);
    m_large.resize(stride);
    for (std::vector<float>* row : {&m_shade, &m_right, &m_up})
        row->resize(stride);
}

// Outside the columns that rows so far have reached, all minima are empty and have never been written.
void SurfaceRows::load(int y) {
    const auto width = static_cast<std::size_t>(m_raster.width);
    const bool inside = m_raster.holds(y);
    const std::uint32_t* keys = inside ? m_raster.row(y) : nullptr;
    if (inside) {
        const kernels::Margins empty = kernels::emptyMargins(keys, width);
        m_margins[static_cast<std::size_t>(y) % m_margins.size()] = empty;
        m_first = std::min(m_first, static_cast<int>(empty.before));
        m_end = std::max(m_end, m_raster.width - static_cast<int>(empty.after));
    }
    if (m_first >= m_end) return;
    const auto count = static_cast<std::size_t>(m_end - m_first);
    std::int32_t* const codes = m_codes.row(y) + margin + m_first;
    if (inside)
        kernels::depthCodes(keys + m_first, count, codes);
    else
        std::fill_n(codes, count, kernels::emptyDepth);
    const int first = margin + m_first - spread;
    const std::size_t wide = count + 2 * spread;
    const auto minimum = [&](const std::int32_t* a, const std::int32_t* b, const std::int32_t* c,
                             std::int32_t* out) {
        kernels::minimumOf3(a + first, b + first, c + first, wide, out + first);
    };
    const std::int32_t* row = m_codes.row(y);
    minimum(row - 1, row, row + 1, m_three.row(y));
    minimum(m_three.row(y - 2), m_three.row(y - 1), m_three.row(y), m_square.row(y - 1));
    row = m_square.row(y - 1);
    minimum(row - 3, row, row + 3, m_nine.row(y - 1));
    minimum(m_nine.row(y - 7), m_nine.row(y - 4), m_nine.row(y - 1), m_large.row(y - 4));
}

kernels::Neighbours SurfaceRows::around(std::size_t radius, int y) {
    const int step = Occlusion::radii[radius];
    const auto row = [&](int at) {
        return radius == 0 ? m_codes.row(at) : radius == 1 ? m_square.row(at) : m_large.row(at);
    };
    return {row(y - step), row(y), row(y + step), static_cast<std::size_t>(step)};
}

SurfaceRow SurfaceRows::next() {
    while (m_loaded <= m_row + reach)
        load(m_loaded++);
    const int y = m_row++;
    SurfaceRow result;
    const auto width = static_cast<std::size_t>(m_raster.width);
    const kernels::Margins empty = m_margins[static_cast<std::size_t>(y) % m_margins.size()];
    if (empty.before == width) return result;
    result.first = static_cast<int>(empty.before);
    result.end = m_raster.width - static_cast<int>(empty.after);
    const auto count = static_cast<std::size_t>(result.end - result.first);
    const std::size_t at = static_cast<std::size_t>(margin) + empty.before;
    for (std::size_t k = 0; k < m_radii.size(); ++k) {
        m_radii[k].neighbours = around(k, y);
        for (const std::int32_t** row :
             {&m_radii[k].neighbours.above, &m_radii[k].neighbours.row, &m_radii[k].neighbours.below})
            *row += at;
    }
    result.codes = m_codes.row(y) + at;
    kernels::shades(result.codes, m_radii, count, m_shade.data());
    kernels::slopes(m_radii[0].neighbours, m_pixelsPerCode, count, m_right.data(), m_up.data());
    result.shade = m_shade.data();
    result.right = m_right.data();
    result.up = m_up.data();
    return result;
}

} // namespace attractor
