// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/affine_map.h"

#include <vector>

// Convex polygons in the plane: their corners, counter-clockwise. 1 or 2 corners make a point or a segment.
namespace ifs {

using Polygon = std::vector<Vector<2>>;

inline double cross(const Vector<2>& p, const Vector<2>& q) {
    return p.x() * q.y() - p.y() * q.x();
}

// The hull of finitely many points, without those within `flatness` of a chord that can do without them.
Polygon convexHull(std::vector<Vector<2>> points, double flatness);

double area(const Polygon& convex);

// 0 inside.
double distanceToConvex(const Polygon& convex, const Vector<2>& x);

} // namespace ifs
