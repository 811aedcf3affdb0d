// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <optional>
#include <span>
#include <vector>

namespace ifs {

// The leading eigenmatrix P of P ↦ Σ ρ_i^emphasis A_iᵀPA_i, symmetric and non-negative, largest
// coefficient 1. It changes with the coordinates as the maps do: maps that are similarities in some
// coordinates satisfy A_iᵀPA_i = s_i²P. The more emphasis, the better √(xᵀPx) fits the slowest maps. nullopt
// when the operator vanishes or overflows. docs/mathematics.md, "Ellipsoidal norm".
template <int Dim>
std::optional<Matrix<Dim>> invariantForm(std::span<const AffineMap<Dim>> maps, double emphasis = 0);

// The same of P ↦ Σ weight_i A_iᵀPA_i.
template <int Dim>
std::optional<Matrix<Dim>> invariantForm(std::span<const AffineMap<Dim>> maps,
                                         const std::vector<double>& weights);

} // namespace ifs
