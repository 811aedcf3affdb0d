// SPDX-License-Identifier: MIT
#include "attractor/solid/clipped_points.h"

#include <algorithm>

namespace attractor {

void drawClipped(const ifs::AffineMap<3>& word, const kernels::SolidWord& shown, const PixelClip& clip,
                 const kernels::Cover& cover, kernels::KeyBand& band) {
    const ifs::Vector<3> across = word.linear.transpose() * clip.normal;
    const double middle = clip.normal.dot(word.translation);
    // Diameter of a cell.
    const double reach = 2.0 * static_cast<double>(cover.spacing) * across.cwiseAbs().sum();
    const double lowest = clip.lowest - reach - middle;
    const double highest = clip.highest + reach - middle;
    constexpr auto maxCode = static_cast<float>(maxDepthCode);
    const auto width = static_cast<float>(band.width());
    const auto rows = static_cast<float>(band.rows());
    const auto colour = static_cast<std::uint32_t>(std::max(shown.colour, 0));
    const kernels::CoverPoints& points = cover.nearestFirst.front();
    for (std::size_t k = 0; k < cover.size; ++k) {
        const float x = points.x[k], y = points.y[k], z = points.z[k];
        const double at = across.x() * static_cast<double>(x) + across.y() * static_cast<double>(y) +
                          across.z() * static_cast<double>(z);
        if (!(at >= lowest && at <= highest)) continue;
        const auto row = [&](std::size_t r) {
            return shown.linear[3 * r] * x + shown.linear[3 * r + 1] * y + shown.linear[3 * r + 2] * z +
                   shown.middle[r];
        };
        const float rightwards = row(0), down = row(1);
        if (!(rightwards >= 0 && rightwards < width && down >= 0 && down < rows)) continue;
        const int column = static_cast<int>(rightwards), line = static_cast<int>(down);
        const auto depth = static_cast<std::uint32_t>(std::clamp(row(2), 0.0F, maxCode));
        std::uint32_t& key = band.keys()[line * band.stride() + column];
        const std::uint32_t found = depth << 8 | colour;
        if (found >= key) continue;
        key = found;
        constexpr int tile = kernels::KeyBand::tile;
        band.stale()[line / tile * band.tilesAcross() + column / tile] = 1;
    }
}

} // namespace attractor
