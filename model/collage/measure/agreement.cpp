// SPDX-License-Identifier: MIT
#include "collage/measure/agreement.h"

#include "collage/measure/attractor_points.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace collage {

namespace {

using Labels = std::vector<std::int32_t>; // label of each cell; 0: empty

struct Place {
    double distance = -1; // cells
    ifs::Vector<2> point = ifs::Vector<2>::Zero();
    std::int32_t layer = 0;
};

// Points on a grid, and those so far outside that only their distance to the target counts.
struct Splats {
    Labels labels; // last layer that met each cell
    std::vector<Place> outside;
    std::int32_t layer = 1; // label of the next layer, > 0; layers are not reused
    std::size_t met = 0;    // number of cells met, summed over all layers
};

std::vector<ifs::AffineMap<2>> inGrid(const Grid& grid, std::span<const ifs::AffineMap<2>> maps) {
    std::vector<ifs::AffineMap<2>> result;
    for (const ifs::AffineMap<2>& map : maps)
        result.push_back(collage::inGrid(grid, map));
    return result;
}

// Adds a point in grid coordinates; outside, an upper bound of its distance to the target.
void splat(const Target& target, double x, double y, Splats& splats) {
    const int width = target.grid.width, height = target.grid.height;
    if (x >= 0 && y >= 0 && x < width && y < height) {
        std::int32_t& label = splats.labels[target.mask.index(int(x), int(y))];
        if (label != splats.layer) ++splats.met;
        label = splats.layer;
        return;
    }
    const double column = std::floor(x), row = std::floor(y);
    const double c = std::clamp(column, 0.0, width - 1.0), r = std::clamp(row, 0.0, height - 1.0);
    const double inside = std::sqrt(double(target.features.square[target.mask.index(int(c), int(r))]));
    splats.outside.push_back({inside + std::hypot(column - c, row - r), {x, y}, splats.layer});
}

class Distances {
public:
    void add(double distance, std::size_t cell, bool isOfTarget) {
        ++m_count[isOfTarget];
        if (distance == 0) return;
        m_sum[isOfTarget] += distance;
        m_positive.push_back(distance);
        if (distance > m_worst.distance) {
            m_worst.distance = distance;
            m_worstCell = std::ptrdiff_t(cell);
        }
    }
    void add(const Place& outside) {
        ++m_count[0];
        m_sum[0] += outside.distance;
        m_positive.push_back(outside.distance);
        if (outside.distance <= m_worst.distance) return;
        m_worst = outside;
        m_worstCell = -1;
    }

    void finish(Agreement& agreement, const Grid& grid) {
        for (const int side : {0, 1})
            if (m_count[side] > 0) agreement.mean += m_sum[side] / double(m_count[side]) / 2;
        const std::size_t all = m_count[0] + m_count[1];
        const std::size_t rank = std::min(all - 1, std::size_t(std::ceil(0.95 * double(all))) - 1);
        const std::size_t zeros = all - m_positive.size();
        if (rank >= zeros) {
            const auto nth = m_positive.begin() + std::ptrdiff_t(rank - zeros);
            std::nth_element(m_positive.begin(), nth, m_positive.end());
            agreement.p95 = *nth;
        }
        agreement.hausdorff = std::max(0.0, m_worst.distance);
        if (m_worstCell >= 0) {
            const std::ptrdiff_t width = grid.width;
            m_worst.point = {double(m_worstCell % width) + 0.5, double(m_worstCell / width) + 0.5};
        }
        agreement.worst = grid.fromGrid()(m_worst.point);
    }

private:
    std::size_t m_count[2] = {0, 0}; // number of cells of the compared set, and of the target
    double m_sum[2] = {0, 0};
    std::vector<double> m_positive;
    Place m_worst;
    std::ptrdiff_t m_worstCell = -1; // worst cell of the grid; −1: the place is known
};

void measureDistances(const Target& target, const Splats& splats, Agreement& agreement) {
    const int width = target.grid.width;
    Distances distances;
    for (std::size_t cell = 0; cell < splats.labels.size(); ++cell)
        if (splats.labels[cell] != 0)
            distances.add(std::sqrt(double(target.features.square[cell])), cell, false);
    for (const Place& place : splats.outside)
        distances.add(place);
    NearestCells nearest;
    nearest.prepare(splats.labels, width, target.grid.height);
    const auto nearestOutside = std::ranges::min_element(splats.outside, {}, &Place::distance);
    for (const std::int32_t cell : target.cells) {
        const int x = cell % width, y = cell / width;
        const NearestCells::Found found =
            splats.labels[std::size_t(cell)] != 0 ? NearestCells::Found{cell, 0} : nearest(x, y);
        // Uses some point off the grid if the grid is empty: the distance is not too small.
        const double distance =
            found.cell >= 0 || nearestOutside == splats.outside.end()
                ? std::sqrt(double(found.square))
                : std::hypot(nearestOutside->point.x() - x - 0.5, nearestOutside->point.y() - y - 0.5);
        distances.add(distance, std::size_t(cell), true);
    }
    distances.finish(agreement, target.grid);
}

// Number of cells met off the grid, and the sum of those that each layer meets.
struct CellsOutside {
    std::size_t all = 0;
    std::size_t met = 0;
};

CellsOutside cellsOutside(const std::vector<Place>& outside) {
    using Cell = std::tuple<double, double, std::int32_t>;
    std::vector<Cell> cells;
    cells.reserve(outside.size());
    for (const Place& place : outside)
        cells.emplace_back(std::floor(place.point.x()), std::floor(place.point.y()), place.layer);
    std::ranges::sort(cells);
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    CellsOutside result{0, cells.size()};
    for (std::size_t k = 0; k < cells.size(); ++k)
        if (k == 0 || std::get<0>(cells[k]) != std::get<0>(cells[k - 1]) ||
            std::get<1>(cells[k]) != std::get<1>(cells[k - 1]))
            ++result.all;
    return result;
}

void measureAreas(const Target& target, const Splats& splats, Agreement& agreement) {
    std::size_t both = 0, only = cellsOutside(splats.outside).all;
    for (std::size_t cell = 0; cell < splats.labels.size(); ++cell)
        if (splats.labels[cell] != 0) ++(target.mask.cells[cell] != 0 ? both : only);
    const auto area = double(target.cells.size());
    agreement.coverage = double(both) / area;
    agreement.excess = double(only) / area;
    agreement.iou = double(both) / (area + double(only));
}

void splatImages(const Target& target, const ifs::AffineMap<2>& map, double dx, double dy, Splats& splats) {
    const ifs::Matrix<2>& a = map.linear;
    const ifs::Vector<2>& b = map.translation;
    for (std::size_t k = 0; k < target.cells.size(); ++k) {
        const double x = target.columns[k] + dx, y = target.rows[k] + dy;
        splat(target, a(0, 0) * x + a(0, 1) * y + b.x(), a(1, 0) * x + a(1, 1) * y + b.y(), splats);
    }
}

// The images of centres are then more than 1/√2 apart; those of four points of each cell are not.
bool mayLeaveGaps(const ifs::AffineMap<2>& map) {
    return ifs::spectralNorm<2>(map.linear) > 0.7;
}

// Bound for |·| derived from ‖·‖: the distance between L and its collage grows by C at most, that between L
// and the attractor does not shrink.
void addBound(CollageMeasure& measure, std::span<const ifs::AffineMap<2>> maps, NormSearch search) {
    const ifs::Existence existence = ifs::classify<2>(maps, search == NormSearch::Hurried ? 2'000 : 20'000);
    if (!existence.hasFactor()) return;
    measure.norm = ifs::contractingNorm<2>(maps, existence);
    measure.bound = measure.norm.equivalence *
                    (measure.images.hausdorff + (2 + measure.contraction) * std::sqrt(0.5)) /
                    (1 - measure.norm.contractivity);
}

} // namespace

double contraction(std::span<const ifs::AffineMap<2>> maps) {
    double largest = 0;
    for (const ifs::AffineMap<2>& map : maps)
        largest = std::max(largest, ifs::spectralNorm<2>(map.linear));
    return largest;
}

double visibleError(const Target& target, const Agreement& attractor) {
    return attractor.mean * target.grid.cell + 0.003 * target.size * (1 - attractor.iou);
}

CollageMeasure collageMeasure(const Target& target, std::span<const ifs::AffineMap<2>> maps) {
    return measuredCollage(target, maps).measure;
}

MeasuredCollage measuredCollage(const Target& target, std::span<const ifs::AffineMap<2>> maps,
                                NormSearch search) {
    const auto inside = inGrid(target.grid, maps);
    Splats splats{Labels(target.mask.cells.size()), {}};
    std::size_t met = 0; // cells met by images without gaps
    for (const ifs::AffineMap<2>& map : inside) {
        splats.met = 0;
        splatImages(target, map, 0, 0, splats);
        if (!mayLeaveGaps(map)) met += splats.met;
        ++splats.layer;
    }
    CollageMeasure result;
    measureDistances(target, splats, result.images);
    for (std::size_t i = 0; i < inside.size(); ++i) {
        if (!mayLeaveGaps(inside[i])) continue;
        std::erase_if(splats.outside, [&](const Place& place) { return place.layer == std::int32_t(i) + 1; });
        splats.met = 0;
        splatImages(target, inside[i], 0, 0, splats);
        for (const double dx : {-0.25, 0.25})
            for (const double dy : {-0.25, 0.25})
                splatImages(target, inside[i], dx, dy, splats);
        met += splats.met;
        ++splats.layer;
    }
    const CellsOutside off = cellsOutside(splats.outside);
    const auto all = std::size_t(std::ranges::count_if(splats.labels, [](auto label) { return label != 0; }));
    result.overlap = double(met + off.met) / double(all + off.all);
    measureAreas(target, splats, result.images);
    result.contraction = contraction(maps);
    addBound(result, maps, search);
    MeasuredCollage measured{result, emptyMask(target.grid.width, target.grid.height)};
    std::ranges::transform(splats.labels, measured.images.cells.begin(),
                           [](std::int32_t label) { return std::uint8_t(label != 0); });
    return measured;
}

Mask attractorMask(const Grid& grid, std::span<const ifs::AffineMap<2>> maps) {
    Mask mask = emptyMask(grid.width, grid.height);
    for (const AttractorPoint& point :
         attractorPoints(inGrid(grid, maps), grid, 0.5, 8 * mask.cells.size() + 1000))
        if (point.x >= 0 && point.y >= 0 && point.x < grid.width && point.y < grid.height)
            mask.cells[mask.index(int(point.x), int(point.y))] = 1;
    return mask;
}

Agreement attractorAgreement(const Target& target, std::span<const ifs::AffineMap<2>> maps) {
    Splats splats{Labels(target.mask.cells.size()), {}};
    // Half-cell steps leave no cell inside the attractor empty.
    for (const AttractorPoint& point :
         attractorPoints(inGrid(target.grid, maps), target.grid, 0.5, 8 * target.mask.cells.size() + 1000))
        splat(target, point.x, point.y, splats);
    Agreement agreement;
    measureDistances(target, splats, agreement);
    measureAreas(target, splats, agreement);
    return agreement;
}

} // namespace collage
