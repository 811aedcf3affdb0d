// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/affine_map.h"

#include <optional>
#include <span>
#include <stop_token>

namespace ifs {

// The D with Σ s_i^D = 1; 0 for a single ratio. Ratios must lie in (0, 1), else nullopt.
std::optional<double> moranDimension(std::span<const double> ratios);

// Moran's D when every map is a similarity, or similar to one by a common change of coordinates that is
// detected from the eigenvalues (plane only: ratio √|det|); nullopt otherwise.
template <int Dim> std::optional<double> similarityDimension(std::span<const AffineMap<Dim>> maps);

// φ^t(A), Falconer's singular value function, t ≥ 0.
template <int Dim> double singularValueFunction(const Matrix<Dim>& linear, double t);

// Falconer's affinity dimension (not capped at Dim), by the transfer operator on directions in the plane, and
// exactly where every map is flat; an upper bound of the box dimension. The error is about 1e-6. nullopt
// without an attractor, where that is not reached, or when stopped.
std::optional<double> affinityDimension(std::span<const AffineMap<2>> maps, const std::stop_token& stop = {});

} // namespace ifs
