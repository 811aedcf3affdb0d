// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/copies/copy_frame.h"

namespace ifs {

// A singular map shows the attractor flat on a line, and nothing of a level below is left to see. Its copies
// are of these bars across the line, which cover the attractor seen along it.
struct CopyProjection {
    std::vector<Polygon> bars; // rectangles; the edge from corner 0 to corner 1 runs along the line
    double detail = 0;         // bound of the distance from points of a bar to the attractor, along the line
};

// Projection for copies by maps that keep only the direction `along`, of length 1, and whose largest singular
// value is at most `length`. Gaps of more than half a pixel are kept, unless that takes too many bars.
CopyProjection projectionAlong(const std::vector<AffineMap<2>>& maps, const CopyFrame& frame,
                               const Vector<2>& along, double length);

// Projection for copies by `map`, raised to be visible at the size of the picture.
CopyProjection projectionBy(const std::vector<AffineMap<2>>& maps, const CopyFrame& frame,
                            const AffineMap<2>& map);

// The direction that a map keeps the most of.
Vector<2> longestDirection(const Matrix<2>& linear);

// Bound of the distance between the bars under `drawn` and the attractor under `map`, both ways.
double maxShift(const CopyFrame& frame, const CopyProjection& projection, const AffineMap<2>& drawn,
                const AffineMap<2>& map);
// The bound in one direction only, from the attractor to the bars.
double maxMissing(const CopyFrame& frame, const CopyProjection& projection, const AffineMap<2>& drawn,
                  const AffineMap<2>& map);

} // namespace ifs
