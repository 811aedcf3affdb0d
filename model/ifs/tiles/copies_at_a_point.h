// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/extent/extent.h"
#include "ifs/separation/neighbour_graph.h"
#include "ifs/system/affine_map.h"

#include <optional>
#include <span>

namespace ifs {

// The area of an attractor with inner points whose copies, moved by a lattice and turned by a finite group,
// cover almost every point equally often: how often is counted at a point with rational coordinates. nullopt
// where the maps are not made of these, or no such point is found. Box and neighbours, if they are known, are
// those of the attractor. docs/mathematics.md, "Tiles".
std::optional<double> areaByCopies(std::span<const AffineMap<2>> maps, const BoundingBox<2>& box,
                                   const NeighbourGraph* neighbours);

} // namespace ifs
