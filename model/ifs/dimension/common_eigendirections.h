// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <optional>
#include <span>
#include <vector>

// Maps of the plane that keep a direction, or two of them together. docs/mathematics.md, "Dimensions".
namespace ifs {

// Directions, of length 1, that every linear part keeps: none, one or two; the first axis where they keep
// all.
std::vector<Vector<2>> commonDirections(std::span<const AffineMap<2>> maps);

// The affinity dimension, at most 2, of maps whose linear parts all keep one direction, or all keep or
// exchange the same two; to rounding. They must have an attractor. nullopt for others.
std::optional<double> commonEigendirectionsDimension(std::span<const AffineMap<2>> maps);

} // namespace ifs
