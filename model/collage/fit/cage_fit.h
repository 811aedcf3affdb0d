// SPDX-License-Identifier: MIT
#pragma once

#include "collage/target/target.h"
#include "ifs/cage/generalized_coordinates.h"

#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace collage {

struct CageFit {
    std::vector<ifs::Vector<2>> vertices; // one for each corner at rest; a simple polygon
    double error = 0;                     // mean distance between both outlines, in units of the plane
};

// Places the corners of a cage so that the outline of the attractor, deformed by the cage, follows the
// outline of the target: closest points, and least squares in the corners, as each point is Σ λ_j v_j.
// docs/mathematics.md, "Collages". `rest` is a simple polygon that holds the attractor of the maps, all of
// which must be contractions. nullopt when no part of the attractor has coordinates in it, and when stopped.
std::optional<CageFit> fittedCage(const Target& target, std::span<const ifs::AffineMap<2>> maps,
                                  std::span<const ifs::Vector<2>> rest, ifs::Coordinates coordinates,
                                  const std::stop_token& stop = {});

// The cells of a mask from which a step leads out of the shape to its surroundings; not into holes.
Mask outerOutline(const Mask& mask);

} // namespace collage
