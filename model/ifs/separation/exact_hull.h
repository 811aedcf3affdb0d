// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/extent/extreme_points.h"
#include "ifs/separation/exact_map.h"
#include "ifs/system/affine_map.h"

#include <optional>
#include <span>
#include <vector>

namespace ifs {

// Returns true if the polygon P of these points, counter-clockwise, or their segment or point, is proved
// without rounding to be the convex hull of the attractor: its vertices are points of the attractor, rational
// numbers by their addresses, and W(P) ⊂ P. The maps must have an attractor. False where an address is
// missing, and where the numbers get too long. docs/mathematics.md, "Extreme points with periodic addresses".
bool isExactHull(std::span<const AffineMap<2>> maps, const std::vector<std::optional<PeriodicPoint>>& points);

// The point without rounding; nullopt for one without an address, or with a long one.
std::optional<ExactPoint<2>> exactPointOf(std::span<const AffineMap<2>> maps,
                                          const std::optional<PeriodicPoint>& address);

// Upper bound of the distances of these points from those of their addresses; all of them must have one.
double roundingOf(std::span<const AffineMap<2>> maps,
                  const std::vector<std::optional<PeriodicPoint>>& points);

} // namespace ifs
