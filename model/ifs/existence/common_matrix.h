// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/existence/exact_matrix.h"
#include "ifs/system/affine_map.h"

#include <optional>
#include <span>

namespace ifs {

// A norm that is known to be contracted by exact arithmetic.
struct CommonMatrixNorm {
    double contractivity = 0; // 1: all maps contract, by factors too near 1 for a double
    double equivalence = 1;   // C with |x| ≤ ‖x‖ ≤ C|x|
};

// An ellipsoidal norm in which maps with linear parts A or −A contract, such as a single map: there is one if
// and only if ρ(A) < 1, which is decided without rounding. nullopt when there is none, when 1 − ρ(A) is below
// 2⁻⁵², or when the linear parts differ. docs/mathematics.md, "When does a system have an attractor?"
template <int Dim> std::optional<CommonMatrixNorm> commonMatrixNorm(std::span<const AffineMap<Dim>> maps);

// The same for one matrix, with any coefficients.
template <int Dim> std::optional<CommonMatrixNorm> exactMatrixNorm(const ExactMatrix<Dim>& linear);

} // namespace ifs
