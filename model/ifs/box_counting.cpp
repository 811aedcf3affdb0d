// SPDX-License-Identifier: MIT
#include "ifs/box_counting.h"

#include <cmath>
#include <numbers>
#include <numeric>

namespace ifs {

void CellGrid::mark(const Vector<2>& x) {
    const double across = std::ldexp(1, levels);
    const double column = std::floor((x.x() - origin.x()) / side * across);
    const double row = std::floor((x.y() - origin.y()) / side * across);
    if (column >= 0 && row >= 0 && column < across && row < across)
        occupied[(std::size_t(row) << levels) + std::size_t(column)] = 1;
}

CellGrid emptyGrid(const Vector<2>& origin, double side, int levels) {
    return {origin, side, levels, std::vector<std::uint8_t>(std::size_t(1) << 2 * levels)};
}

std::vector<std::uint64_t> boxCounts(CellGrid grid) {
    std::vector<std::uint64_t> counts(std::size_t(grid.levels) + 1);
    for (int level = grid.levels;; --level) {
        const std::size_t across = std::size_t(1) << level;
        counts[std::size_t(level)] = std::accumulate(
            grid.occupied.begin(), grid.occupied.begin() + std::ptrdiff_t(across * across), std::uint64_t{0});
        if (level == 0) return counts;
        for (std::size_t row = 0; row < across / 2; ++row) // in place: what is read lies ahead
            for (std::size_t column = 0; column < across / 2; ++column) {
                const std::uint8_t* cell = &grid.occupied[2 * row * across + 2 * column];
                grid.occupied[row * (across / 2) + column] =
                    cell[0] | cell[1] | cell[across] | cell[across + 1];
            }
    }
}

std::optional<LogLogFit> fitted(const std::vector<std::uint64_t>& counts, int first, int last) {
    const int size = last - first + 1;
    if (first < 0 || size < 2 || last >= int(counts.size())) return std::nullopt;
    double meanX = 0, meanY = 0;
    for (int k = first; k <= last; ++k) {
        if (counts[std::size_t(k)] == 0) return std::nullopt;
        meanX += k * std::numbers::ln2 / size;
        meanY += std::log(double(counts[std::size_t(k)])) / size;
    }
    double xy = 0, xx = 0, yy = 0;
    for (int k = first; k <= last; ++k) {
        const double x = k * std::numbers::ln2 - meanX, y = std::log(double(counts[std::size_t(k)])) - meanY;
        xy += x * y;
        xx += x * x;
        yy += y * y;
    }
    const double slope = xy / xx;
    return LogLogFit{slope, meanY - slope * meanX, std::sqrt(std::max(0.0, yy - slope * xy) / size)};
}

std::optional<CellGrid> occupiedCells(const SupportFunction<2>& support, int levels, double cells,
                                      std::size_t maxWords) {
    const BoundingBox<2> box = boundingBox(support, 1e-9 * support.radius());
    // A little more than the box, so that its upper and right borders fall inside.
    const double extent = (box.max - box.min).maxCoeff() + 2 * box.error, side = extent * (1 + 0x1p-30);
    if (!(side > 0)) return std::nullopt;
    CellGrid grid = emptyGrid(box.min - Vector<2>::Constant(box.error), side, levels);
    const double size = cells * std::ldexp(side, -levels) / (2 * support.radius());
    std::vector<AffineMap<2>> open{{}};
    std::size_t words = 0;
    while (!open.empty()) {
        const AffineMap<2> map = open.back();
        open.pop_back();
        if (++words > maxWords) return std::nullopt;
        if (spectralNorm<2>(map.linear) <= size) {
            grid.mark(map(support.pointOfAttractor()));
            continue;
        }
        for (const auto& next : support.maps())
            open.push_back(map * next);
    }
    return grid;
}

} // namespace ifs
