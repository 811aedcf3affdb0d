// SPDX-License-Identifier: MIT
#include "ifs/box_counting.h"

#include "ifs/facts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace ifs {

bool CellGrid::mark(const Vector<2>& x) {
    const double across = std::ldexp(1, levels);
    const double column = std::floor((x.x() - origin.x()) / side * across);
    const double row = std::floor((x.y() - origin.y()) / side * across);
    if (!(column >= 0 && row >= 0 && column < across && row < across)) return false;
    std::uint8_t& cell = occupied[(std::size_t(row) << levels) + std::size_t(column)];
    const bool isNew = cell == 0;
    cell = 1;
    return isNew;
}

CellGrid emptyGrid(const Vector<2>& origin, double side, int levels) {
    return {origin, side, levels, std::vector<std::uint8_t>(std::size_t(1) << 2 * levels)};
}

namespace {

// Cells of twice the side.
CellGrid halved(const CellGrid& grid) {
    CellGrid result = emptyGrid(grid.origin, grid.side, grid.levels - 1);
    const std::size_t across = std::size_t(1) << grid.levels;
    for (std::size_t k = 0; k < grid.occupied.size(); ++k) {
        const std::size_t row = k / across, column = k % across;
        result.occupied[row / 2 * (across / 2) + column / 2] |= grid.occupied[k];
    }
    return result;
}

} // namespace

std::vector<std::uint64_t> boxCounts(CellGrid grid) {
    std::vector<std::uint64_t> counts(std::size_t(grid.levels) + 1);
    for (;; grid = halved(grid)) {
        counts[std::size_t(grid.levels)] =
            std::accumulate(grid.occupied.begin(), grid.occupied.end(), std::uint64_t{0});
        if (grid.levels == 0) return counts;
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

std::optional<CellGrid> occupiedCells(const SupportFunction<2>& support, int levels,
                                      const AffineMap<2>& image, const std::stop_token& stop) {
    const BoundingBox<2> box = boundingBoxOfImage(
        image, support, 1e-9 * support.radius() * std::max(1.0, spectralNorm<2>(image.linear)));
    // A little more than the box, so that its upper and right borders fall inside.
    const double side = ((box.max - box.min).maxCoeff() + 2 * box.error) * (1 + 0x1p-30);
    if (!(side > 64 * box.error)) return std::nullopt;
    CellGrid fine = emptyGrid(box.min - Vector<2>::Constant(box.error), side, levels + 1);
    std::vector<Vector<2>> open{support.pointOfAttractor()};
    fine.mark(image(open.back()));
    while (!open.empty()) {
        if (open.size() % 1024 == 0 && stop.stop_requested()) return std::nullopt;
        const Vector<2> point = open.back();
        open.pop_back();
        for (const auto& map : support.maps()) {
            const Vector<2> next = map(point);
            if (fine.mark(image(next))) open.push_back(next);
        }
    }
    return halved(fine);
}

std::optional<BoxCounting> boxCounting(const SupportFunction<2>& support, const AffineMap<2>& image,
                                       const std::stop_token& stop) {
    constexpr int Levels = 9, First = 2, Last = Levels - 1;
    auto grid = occupiedCells(support, Levels, image, stop);
    if (!grid) return std::nullopt;
    BoxCounting result{.counts = {}, .side = grid->side, .first = First, .last = Last, .fit = {}};
    result.counts = boxCounts(*std::move(grid));
    const auto fit = fitted(result.counts, First, Last);
    if (!fit) return std::nullopt;
    result.fit = *fit;
    return result;
}

} // namespace ifs
