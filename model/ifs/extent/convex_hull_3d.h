// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/extent/support_function.h"

#include <array>
#include <optional>
#include <stop_token>
#include <vector>

namespace ifs {

// The convex hull in space, to a tolerance. A set within a plane, on a line or in one point has volume 0, and
// facets only on one side of the plane, or none.
struct ConvexHull3 {
    std::vector<Vector<3>> vertices;
    std::vector<std::array<int, 3>> facets; // triangles, counter-clockwise seen from outside
    double volume = 0;
    double error = 0;
};
ConvexHull3 convexHull(const SupportFunction<3>& support, double tolerance);
// nullopt when stopped.
std::optional<ConvexHull3> convexHull(const SupportFunction<3>& support, double tolerance,
                                      const std::stop_token& stop);

// Upper bound of the volume by which conv A exceeds the polyhedron: Steiner's formula for its error, with the
// diameter in place of the mean width.
double volumeError(const ConvexHull3& hull);

} // namespace ifs
