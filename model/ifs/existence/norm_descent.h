// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <span>

namespace ifs {

// Coordinates y = root·x and the longest of the maps there, max ‖root·A_i·root⁻¹‖.
template <int Dim> struct NormCoordinates {
    Matrix<Dim> root;
    double longest = 0;
};

// Follows the steepest descent of log max ‖root·A_i·root⁻¹‖, a convex function of rootᵀ·root along the
// geodesics of the positive definite matrices, from coordinates that are known until the maps contract well.
// docs/mathematics.md, "Ellipsoidal norm".
template <int Dim> void descend(NormCoordinates<Dim>& best, std::span<const AffineMap<Dim>> maps);

} // namespace ifs
