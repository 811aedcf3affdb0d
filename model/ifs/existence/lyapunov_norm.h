// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/existence/common_matrix.h"
#include "ifs/system/affine_map.h"

#include <optional>
#include <span>

namespace ifs {

// The ellipsoidal norm √(xᵀPx) with P − Σ wᵢ AᵢᵀPAᵢ = I for some weights wᵢ, solved in rational numbers, if
// all P − AᵢᵀPAᵢ are positive definite: known without rounding, however large the coefficients are. The
// weights are equal, or all but one of them 0. nullopt where they are not, and of many maps.
// docs/mathematics.md, "When does a system have an attractor?"
template <int Dim> std::optional<CommonMatrixNorm> lyapunovNorm(std::span<const AffineMap<Dim>> maps);

// The norm √(xᵀPx) of this matrix P, under the same condition.
template <int Dim>
std::optional<CommonMatrixNorm> ellipsoidNorm(std::span<const AffineMap<Dim>> maps,
                                              const Matrix<Dim>& symmetric);

} // namespace ifs
