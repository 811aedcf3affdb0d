// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/existence/common_matrix.h"
#include "ifs/system/affine_map.h"

#include <optional>
#include <span>

namespace ifs {

// The ellipsoidal norm √(xᵀPx) with P − w Σ AᵢᵀPAᵢ = I for some weight w, solved in rational numbers, if all
// P − AᵢᵀPAᵢ are positive definite: known without rounding, however large the coefficients are. nullopt where
// they are not, and of many maps. docs/mathematics.md, "When does a system have an attractor?"
template <int Dim> std::optional<CommonMatrixNorm> lyapunovNorm(std::span<const AffineMap<Dim>> maps);

} // namespace ifs
