// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/extent/polygon.h"
#include "ifs/system/affine_map.h"

#include <cstdint>
#include <vector>

namespace ifs {

// Upper bounds of the distance of shapes from an attractor, from points of the attractor in the cells of a
// grid. Where the points are dense, a bound exceeds the distance by less than two cells.
class CopyDistance {
public:
    static constexpr double finest = 0.25; // side of a cell in pixels, unless there would be too many cells

    // Prepares distances to the displayed attractor of `maps`: its images under the maps `shown`, in pixels.
    // The attractor lies in `hull`.
    CopyDistance(const std::vector<AffineMap<2>>& maps, const std::vector<AffineMap<2>>& shown,
                 const Polygon& hull);

    // Upper bound of the distance of a point of the convex polygon, in pixels.
    double farthest(const Polygon& polygon) const;

private:
    struct Offset { // vector to the cell of a point
        std::int16_t x = unknown;
        std::int16_t y = unknown;

        static constexpr std::int16_t unknown = 16'000;
        int square() const { return int(x) * x + int(y) * y; }
    };

    std::size_t index(int column, int row) const {
        return std::size_t(row) * std::size_t(m_columns) + std::size_t(column);
    }
    int columnOf(double x) const;
    int rowOf(double y) const;
    void mark(const std::vector<AffineMap<2>>& maps, const std::vector<AffineMap<2>>& shown);
    void spread();
    void improve(int column, int row, int dx, int dy);
    double distanceAt(int column, int row) const;

    Vector<2> m_corner = Vector<2>::Zero();
    double m_cell = finest;
    int m_columns = 1;
    int m_rows = 1;
    std::vector<Offset> m_nearest;
};

} // namespace ifs
