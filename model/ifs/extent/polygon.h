// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <vector>

// Convex polygons in the plane: their corners, counter-clockwise. 1 or 2 corners make a point or a segment.
namespace ifs {

using Polygon = std::vector<Vector<2>>;

inline double cross(const Vector<2>& p, const Vector<2>& q) {
    return p.x() * q.y() - p.y() * q.x();
}

// Corners of the hull of finitely many points such that all of it lies within `flatness`, and 4 roundings of
// its size, of the polygon. Those that this lets go are left out. docs/mathematics.md, "Convex hull".
Polygon convexHull(std::vector<Vector<2>> points, double flatness);

double area(const Polygon& convex);

double distanceToSegment(const Vector<2>& x, const Vector<2>& p, const Vector<2>& q);

// 0 inside.
double distanceToConvex(const Polygon& convex, const Vector<2>& x);

} // namespace ifs
