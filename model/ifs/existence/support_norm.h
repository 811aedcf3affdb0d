// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/existence/common_matrix.h"
#include "ifs/system/affine_map.h"

#include <optional>
#include <span>

namespace ifs {

// An ellipsoidal norm, along the axes, in which all maps contract, by what is known without rounding: the
// strong components of the graph of coefficients that do not vanish are single axes, or all maps have at most
// one coefficient a row and a column there; cycles of the largest coefficients have products below 1. So are
// triangular maps, and such as permute the axes. nullopt where maps are not of this kind.
// docs/mathematics.md, "When does a system have an attractor?"
template <int Dim> std::optional<CommonMatrixNorm> supportNorm(std::span<const AffineMap<Dim>> maps);

// The Euclidean norm, where all I − AᵢᵀAᵢ are positive definite without rounding; equivalence 1.
template <int Dim> std::optional<CommonMatrixNorm> exactEuclideanNorm(std::span<const AffineMap<Dim>> maps);

} // namespace ifs
