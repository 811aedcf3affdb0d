// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <array>
#include <span>

namespace ifs {

// Dim + 1 points: a triangle in the plane, a tetrahedron in space.
template <int Dim> using Simplex = std::array<Vector<Dim>, Dim + 1>;
template <int Dim> using Barycentric = Eigen::Matrix<double, Dim + 1, 1>;

// |det| ≥ 1e-9·ℓ^Dim, with ℓ the longest edge: the vertices are far enough from one line (plane) to hold
// coordinates.
template <int Dim> bool isAffineBasis(const Simplex<Dim>& simplex);

// Coordinates of x relative to the simplex, by the edge form (the inverse of T is never formed); they sum
// to 1. The simplex must be an affine basis.
template <int Dim> Barycentric<Dim> barycentric(const Simplex<Dim>& simplex, const Vector<Dim>& x);

// Σ λ_j V_j. The simplex may be degenerate.
template <int Dim> Vector<Dim> point(const Simplex<Dim>& simplex, const Barycentric<Dim>& coordinates);

// The affine map that takes the vertices `from` to the vertices `to`; only `from` needs to be an affine
// basis.
template <int Dim> AffineMap<Dim> simplexMap(const Simplex<Dim>& from, const Simplex<Dim>& to);

} // namespace ifs
