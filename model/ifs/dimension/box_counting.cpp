// SPDX-License-Identifier: MIT
#include "ifs/dimension/box_counting.h"

#include "ifs/extent/extent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

namespace ifs {

namespace {

// Number of a cell, row by row, where the grid is cut into 2^levels × 2^levels of them; nullopt outside.
std::optional<std::size_t> cellOf(const Vector<2>& x, const CellGrid& grid, int levels) {
    const auto across = double(std::size_t(1) << levels);
    const double column = std::floor((x.x() - grid.origin.x()) / grid.side * across);
    const double row = std::floor((x.y() - grid.origin.y()) / grid.side * across);
    if (!(column >= 0 && row >= 0 && column < across && row < across)) return std::nullopt;
    return (std::size_t(row) << levels) + std::size_t(column);
}

} // namespace

bool CellGrid::mark(const Vector<2>& x) {
    const auto number = cellOf(x, *this, levels);
    if (!number) return false;
    std::uint8_t& cell = occupied[*number];
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
                                      const AffineMap<2>& image, const std::stop_token& stop,
                                      double minSide) {
    const BoundingBox<2> box = boundingBoxOfImage(
        image, support, 1e-9 * support.radius() * std::max(1.0, spectralNorm<2>(image.linear)));
    // Slightly enlarged box, so that its upper and right borders fall inside.
    const double least = ((box.max - box.min).maxCoeff() + 2 * box.error) * (1 + 0x1p-30);
    if (!(least > 64 * box.error)) return std::nullopt;
    const double side = std::max(least, minSide);
    CellGrid grid = emptyGrid(box.min - Vector<2>::Constant(box.error), side, levels);
    // One bit for each half-cell, so that all bits stay in the processor's cache.
    std::vector<std::uint64_t> halves((std::size_t(1) << 2 * (levels + 1)) / 64 + 1);
    const auto mark = [&](const Vector<2>& x) {
        const auto half = cellOf(x, grid, levels + 1);
        if (!half) return false;
        std::uint64_t& word = halves[*half / 64];
        const std::uint64_t bit = std::uint64_t{1} << (*half % 64);
        if (word & bit) return false;
        word |= bit;
        const std::size_t row = *half >> (levels + 1), column = *half & ((std::size_t(2) << levels) - 1);
        grid.occupied[((row / 2) << levels) + column / 2] = 1;
        return true;
    };
    std::vector<Vector<2>> open{support.pointOfAttractor()};
    mark(image(open.back()));
    while (!open.empty()) {
        if (open.size() % 1024 == 0 && stop.stop_requested()) return std::nullopt;
        const Vector<2> point = open.back();
        open.pop_back();
        for (const auto& map : support.maps()) {
            const Vector<2> next = map(point);
            if (mark(image(next))) open.push_back(next);
        }
    }
    return grid;
}

std::vector<std::uint64_t> leastBoxCounts(const CellGrid& grid) {
    const std::size_t across = std::size_t(1) << grid.levels;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> cells;
    for (std::size_t k = 0; k < grid.occupied.size(); ++k)
        if (grid.occupied[k]) cells.emplace_back(std::uint32_t(k % across), std::uint32_t(k / across));
    std::vector<std::uint64_t> result;
    std::vector<std::uint8_t> boxes;
    for (int level = 0; level < grid.levels; ++level) {
        const int shift = grid.levels - level;
        const std::uint32_t half = std::uint32_t(1) << (shift - 1);
        const std::size_t width = (std::size_t(1) << level) + 1;
        std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
        for (const auto& [dx, dy] : {std::pair{0U, 0U}, {half, 0U}, {0U, half}, {half, half}}) {
            boxes.assign(width * width, 0);
            for (const auto& [x, y] : cells)
                boxes[std::size_t((y + dy) >> shift) * width + ((x + dx) >> shift)] = 1;
            least = std::min(least, std::accumulate(boxes.begin(), boxes.end(), std::uint64_t{0}));
        }
        result.push_back(least);
    }
    return result;
}

namespace {

// The line through a range, and by how much the slopes over parts of it of at least half its length differ.
struct RangeFit {
    int first = 0;
    LogLogFit fit;
    double spread = 0;
    // True if the slopes of parts of one length only rise or only fall, without having settled.
    bool isSteady = true;
};

std::optional<RangeFit> rangeFit(const std::vector<std::uint64_t>& counts, int first, int last) {
    const auto whole = fitted(counts, first, last);
    if (!whole) return std::nullopt;
    RangeFit result{.first = first, .fit = *whole};
    const int part = std::max(2, (last - first + 1) / 2);
    bool grows = false, falls = false;
    std::optional<double> before;
    for (int from = first; from + part <= last; ++from) {
        const auto fit = fitted(counts, from, from + part);
        if (!fit) continue;
        result.spread = std::max(result.spread, std::abs(fit->slope - whole->slope));
        grows = grows || (before && fit->slope > *before);
        falls = falls || (before && fit->slope < *before);
        before = fit->slope;
    }
    result.isSteady = !(grows && falls);
    return result;
}

// Finest levels that a few million cells allow, when every map looks at each occupied cell.
int finestLevels(const CellGrid& coarse, std::size_t maps) {
    constexpr std::uint64_t maxWork = 40'000'000;
    constexpr int finest = 11;
    const std::uint64_t occupied =
        std::accumulate(coarse.occupied.begin(), coarse.occupied.end(), std::uint64_t{0});
    int levels = coarse.levels;
    while (levels < finest && (occupied * maps << 2 * (levels + 2 - coarse.levels)) <= maxWork)
        ++levels;
    return levels;
}

} // namespace

namespace {

constexpr int coarsest = 9; // levels

// Changes of the slopes over the range when the boxes are turned: by a quarter of a right angle, by half and
// by three quarters of one. Coarser cells make it fast. nullopt when stopped.
std::optional<double> changeByTurning(const SupportFunction<2>& support, const AffineMap<2>& image,
                                      const BoxCounting& counting, int distorted,
                                      const std::stop_token& stop) {
    const int last = std::min(counting.last, coarsest - 1 - distorted);
    const int first = std::min(counting.first, last - 2);
    double change = 0;
    for (const int quarters : {1, 2, 3}) {
        const double angle = quarters * std::numbers::pi / 8, c = std::cos(angle), s = std::sin(angle);
        const auto grid =
            occupiedCells(support, coarsest, affineMap(c, -s, s, c, 0, 0) * image, stop, counting.side);
        if (!grid) return std::nullopt;
        const auto turned = fitted(leastBoxCounts(*grid), first, last);
        if (turned) change = std::max(change, std::abs(turned->slope - counting.fit.slope));
    }
    return change;
}

} // namespace

std::optional<BoxCounting> boxCounting(const SupportFunction<2>& support, const AffineMap<2>& image,
                                       const std::stop_token& stop) {
    constexpr int minFirst = 2, shortest = 5, maxDistorted = 4;
    auto grid = occupiedCells(support, coarsest, image, stop);
    if (!grid) return std::nullopt;
    if (const int levels = finestLevels(*grid, support.maps().size()); levels > coarsest)
        grid = occupiedCells(support, levels, image, stop);
    if (!grid) return std::nullopt;
    BoxCounting result{.counts = leastBoxCounts(*grid), .side = grid->side, .fit = {}};
    // Limit of the finest counts: a marked cell may be as far as `distance` from the next point, so that
    // these counts are too small.
    const double distance = 0.5 * support.normEquivalence() / (1 - support.contractivity());
    constexpr double tooFar = 64; // leaves hardly any size
    if (!(distance <= tooFar)) return std::nullopt;
    const int distorted = std::clamp(std::ilogb(distance) + 1, 0, maxDistorted);
    result.last = int(result.counts.size()) - 1 - distorted;
    std::optional<RangeFit> best;
    for (int first = minFirst; first + shortest - 1 <= result.last; ++first)
        if (const auto range = rangeFit(result.counts, first, result.last);
            range && (!best || range->spread < best->spread))
            best = range;
    if (!best) return std::nullopt;
    constexpr double minSpread = 0.02; // error of a slope from so few sizes
    result.first = best->first;
    result.fit = best->fit;
    const auto turned = changeByTurning(support, image, result, distorted, stop);
    if (!turned) return std::nullopt;
    result.uncertainty = std::max({(best->isSteady ? 6 : 4) * best->spread, *turned * 1.5, minSpread});
    return result;
}

} // namespace ifs
