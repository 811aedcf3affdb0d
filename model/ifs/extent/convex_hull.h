// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/extent/support_function.h"

#include <optional>
#include <stop_token>
#include <vector>

namespace ifs {

// Extreme points of the convex hull to a tolerance, counter-clockwise, each on the attractor.
struct ConvexHull {
    std::vector<Vector<2>> vertices; // 1 for a point, 2 for a segment
    double area = 0;
    double error = 0; // a-posteriori bound of the distance from conv A to the polygon
};
ConvexHull convexHull(const SupportFunction<2>& support, double tolerance);
// nullopt when stopped.
std::optional<ConvexHull> convexHull(const SupportFunction<2>& support, double tolerance,
                                     const std::stop_token& stop);

// Upper bound of the area by which conv A exceeds the polygon: Steiner's formula for its error.
double areaError(const ConvexHull& hull);

} // namespace ifs
