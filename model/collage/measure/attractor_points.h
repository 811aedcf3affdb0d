// SPDX-License-Identifier: MIT
#pragma once

#include "collage/target/target.h"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace collage {

// A point of the attractor: map `map` of point `parent`. The first point is its own parent, the fixed point
// of map 0.
struct AttractorPoint {
    double x = 0;
    double y = 0;
    std::int32_t parent = 0;
    std::int32_t map = 0;
};

// Points of the attractor, at most one in each square of side `step`, in breadth-first order from the fixed
// point of the first map: every square that a map leads to from one with a point has a point. Maps and points
// are in the coordinates of the grid, which the attractor may leave. Empty when the first map has no fixed
// point; not more than `maxPoints`. docs/mathematics.md, "Collages".
std::vector<AttractorPoint> attractorPoints(std::span<const ifs::AffineMap<2>> maps, const Grid& grid,
                                            double step, std::size_t maxPoints);

// Derivatives of the points by the numbers a b c d e f of all maps: two rows for each point, six columns for
// each map.
using PointDerivatives = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
PointDerivatives pointDerivatives(std::span<const ifs::AffineMap<2>> maps,
                                  std::span<const AttractorPoint> points);

} // namespace collage
