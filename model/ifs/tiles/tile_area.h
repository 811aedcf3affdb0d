// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/extent/extent.h"
#include "ifs/separation/neighbour_graph.h"
#include "ifs/separation/surd_map.h"
#include "ifs/system/affine_map.h"

#include <optional>
#include <span>

namespace ifs {

struct TileArea {
    double value = 0;
    Certainty certainty = Certainty::Exact;
};

// The area of an attractor with inner points whose copies, moved by a lattice and by the finitely many
// rotations and reflections that the maps consist of, cover the plane equally often everywhere. nullopt where
// that is not proved within bounded work. Box and neighbours, if they are known, are those of the attractor.
// docs/mathematics.md, "Tiles".
std::optional<TileArea> tileArea(std::span<const AffineMap<2>> maps, const BoundingBox<2>& box,
                                 const NeighbourGraph* neighbours);

// Returns true if the area given by the lattice of the digits is proved for the typed maps: they all have one
// linear part, and the integers found give them back without rounding.
bool isAreaOf(std::span<const AffineMap<2>> maps, std::span<const SurdMap> typed);

} // namespace ifs
