// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/extent/extreme_points.h"
#include "ifs/system/affine_map.h"

#include <optional>
#include <span>
#include <vector>

namespace ifs {

// Returns true if the images of the convex hull P of these points cover P, without rounding. If isExactHull()
// holds, too, then W(P) = P is the attractor, which is connected. False where this would take too much work.
bool imagesCoverHull(std::span<const AffineMap<2>> maps,
                     const std::vector<std::optional<PeriodicPoint>>& points);

// Returns true if P is a polygon of which no two images have a common inner point, and none is flat, without
// rounding: the open set condition holds with the inside of P, if isExactHull() holds. False where this would
// take too much work.
bool haveImagesDisjointInsides(std::span<const AffineMap<2>> maps,
                               const std::vector<std::optional<PeriodicPoint>>& points);

} // namespace ifs
