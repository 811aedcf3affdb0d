// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/extent/polygon.h"
#include "ifs/extent/support_function.h"

// Cages of few corners around a convex hull. All polygons are convex and counter-clockwise; a hull may be a
// point or a segment. docs/mathematics.md, "Cages around a hull".
namespace ifs {

// A polygon that contains everything within `distance` of the hull, and nothing farther than √2·distance.
// `distance` must be positive when the hull is a point or a segment.
Polygon enlargedHull(const Polygon& hull, double distance);
// The certified hull of an attractor, enlarged by its error and a millionth of its radius.
Polygon enlargedHull(const SupportFunction<2>& support);

// A polygon of at most `corners` ≥ 3 corners around the hull, made by replacing edges by the point where
// their neighbours meet, least area first. A hull that has no more corners comes back as it is. The hull must
// have at least three.
Polygon simplifiedHull(const Polygon& hull, int corners);

// The rectangle of least area around the hull, of any direction; one side lies along an edge of the hull,
// which must have at least three corners.
Polygon smallestRectangleAround(const Polygon& hull);

// The smallest regular polygon of `corners` ≥ 3 corners and level base around the hull; its first edge is the
// base. Around a single point: that with distance 1 from centre to edges.
Polygon regularPolygonAround(const Polygon& hull, int corners);

} // namespace ifs
