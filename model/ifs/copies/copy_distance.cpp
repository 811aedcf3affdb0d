// SPDX-License-Identifier: MIT
#include "ifs/copies/copy_distance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ifs {

namespace {

constexpr double maxCells = 4e6;
constexpr double border = 3; // pixels

struct Range {
    double low = HUGE_VAL;
    double high = -HUGE_VAL;
    void add(double x) {
        low = std::min(low, x);
        high = std::max(high, x);
    }
    double length() const { return high - low; }
};

} // namespace

CopyDistance::CopyDistance(const std::vector<AffineMap<2>>& maps, const std::vector<AffineMap<2>>& shown,
                           const Polygon& hull) {
    Range x, y;
    for (const auto& map : shown)
        for (const auto& corner : hull) {
            const Vector<2> pixel = map(corner);
            x.add(pixel.x());
            y.add(pixel.y());
        }
    const double width = x.length() + 2 * border, height = y.length() + 2 * border;
    // Also limits the cells of a side to the range of an offset.
    m_cell = std::max({finest, std::sqrt(width * height / maxCells), std::max(width, height) / 8000});
    m_corner = {x.low - border, y.low - border};
    m_columns = int(width / m_cell) + 1;
    m_rows = int(height / m_cell) + 1;
    m_nearest.resize(std::size_t(m_columns) * std::size_t(m_rows));
    mark(maps, shown);
    spread();
}

int CopyDistance::columnOf(double x) const {
    return int(std::clamp(std::floor((x - m_corner.x()) / m_cell), 0.0, m_columns - 1.0));
}

int CopyDistance::rowOf(double y) const {
    return int(std::clamp(std::floor((y - m_corner.y()) / m_cell), 0.0, m_rows - 1.0));
}

// Marks cells from a point of the attractor on: the images of a point are followed where they touch a new
// cell.
void CopyDistance::mark(const std::vector<AffineMap<2>>& maps, const std::vector<AffineMap<2>>& shown) {
    const auto first =
        std::ranges::find_if(maps, [](const auto& map) { return fixedPoint(map).has_value(); });
    if (first == maps.end()) return;
    std::vector<Vector<2>> open{*fixedPoint(*first)};
    const auto touches = [&](const Vector<2>& point) {
        bool isNew = false;
        for (const auto& map : shown) {
            const Vector<2> pixel = map(point);
            Offset& offset = m_nearest[index(columnOf(pixel.x()), rowOf(pixel.y()))];
            isNew = isNew || offset.x != 0;
            offset = {0, 0};
        }
        return isNew;
    };
    touches(open.front());
    while (!open.empty()) {
        const Vector<2> point = open.back();
        open.pop_back();
        for (const auto& map : maps)
            if (const Vector<2> image = map(point); touches(image)) open.push_back(image);
    }
}

void CopyDistance::improve(int column, int row, int dx, int dy) {
    if (column + dx < 0 || column + dx >= m_columns || row + dy < 0 || row + dy >= m_rows) return;
    const Offset& there = m_nearest[index(column + dx, row + dy)];
    if (there.x == Offset::unknown) return;
    const Offset candidate{std::int16_t(there.x + dx), std::int16_t(there.y + dy)};
    Offset& here = m_nearest[index(column, row)];
    if (candidate.square() < here.square()) here = candidate;
}

// Passes distances to every cell from its neighbours, downwards and upwards (Danielsson 1980).
void CopyDistance::spread() {
    for (const int way : {-1, 1}) {
        for (int k = 0; k < m_rows; ++k) {
            const int row = way < 0 ? k : m_rows - 1 - k;
            for (int column = 0; column < m_columns; ++column) {
                for (const int dx : {0, -1, 1})
                    improve(column, row, dx, way);
                improve(column, row, -1, 0);
            }
            for (int column = m_columns - 1; column >= 0; --column)
                improve(column, row, 1, 0);
        }
    }
}

// Upper bound of the distance: half a diagonal from any point of the cell to its middle, and the same at the
// other end.
double CopyDistance::distanceAt(int column, int row) const {
    const int x = std::clamp(column, 0, m_columns - 1), y = std::clamp(row, 0, m_rows - 1);
    const Offset& nearest = m_nearest[index(x, y)];
    if (nearest.x == Offset::unknown) return HUGE_VAL;
    return m_cell * (std::hypot(nearest.x + x - column, nearest.y + y - row) + std::numbers::sqrt2);
}

double CopyDistance::farthest(const Polygon& polygon) const {
    constexpr double largest = 20'000; // cells
    std::vector<Vector<2>> corners;    // in cells
    Range x, y;
    for (const auto& corner : polygon) {
        corners.emplace_back((corner - m_corner) / m_cell);
        x.add(corners.back().x());
        y.add(corners.back().y());
    }
    if (!(x.length() < largest && y.length() < largest && std::abs(x.low) < 1e9 && std::abs(y.low) < 1e9))
        return HUGE_VAL;
    const int top = int(std::floor(y.low));
    // Range of cells of the polygon in each row.
    std::vector<Range> rows(std::size_t(int(std::floor(y.high)) - top + 1));
    for (std::size_t i = 0; i < corners.size(); ++i) {
        Vector<2> a = corners[i], b = corners[(i + 1) % corners.size()];
        if (a.y() > b.y()) std::swap(a, b);
        const int from = int(std::floor(a.y())), to = int(std::floor(b.y()));
        const auto at = [&](double height) {
            return a.x() + (b.x() - a.x()) * (height - a.y()) / (b.y() - a.y());
        };
        for (int row = from; row <= to; ++row) {
            Range& range = rows[std::size_t(row - top)];
            range.add(row == from ? a.x() : at(row));
            range.add(row == to ? b.x() : at(row + 1));
        }
    }
    double outside = 0; // distance of the cells outside the grid
    int inside = -1;    // largest square of the other distances
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const int row = top + int(k);
        const int from = int(std::floor(rows[k].low)), to = int(std::floor(rows[k].high));
        const bool isIn = row >= 0 && row < m_rows && from >= 0 && to < m_columns;
        for (int column = from; column <= to; ++column)
            if (isIn)
                inside = std::max(inside, m_nearest[index(column, row)].square());
            else
                outside = std::max(outside, distanceAt(column, row));
    }
    if (inside < 0) return outside;
    return std::max(outside, inside < Offset{}.square() ? m_cell * (std::sqrt(inside) + std::numbers::sqrt2)
                                                        : HUGE_VAL);
}

} // namespace ifs
