// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/extent/extent.h"
#include "ifs/separation/neighbour_graph.h"
#include "ifs/system/affine_map.h"

#include <optional>
#include <span>

// Attractors with inner points, made of copies that meet in their boundaries alone. docs/mathematics.md,
// "Tiles".
namespace ifs {

struct Tile {
    std::optional<double> area;              // area of a tile whose copies cover the plane equally often
    std::optional<double> boundaryDimension; // known if all maps are similarities of one ratio
    double boundaryDimensionError = 0;       // error bound
    bool isExact = false; // true: proved for the exact coefficients; false: up to their rounding
};

// The tile, or nullopt where neither kind is proved within bounded work. Box and neighbours, if known, are
// those of the attractor.
std::optional<Tile> tile(std::span<const AffineMap<2>> maps, const BoundingBox<2>& box,
                         const NeighbourGraph* neighbours);

} // namespace ifs
