// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/barycentric.h"

#include <span>
#include <vector>

// Affine invariant systems (Kocić and Simoncelli): a simplex, and a row-stochastic matrix for every map.
// docs/mathematics.md, "Affine invariant form".
namespace ifs {

// Row j holds the barycentric coordinates of w(V_j); rows sum to 1, entries may be negative. A row vector r
// of coordinates goes to r·S, so w_i∘w_j has the matrix S_j·S_i.
template <int Dim> using RowStochastic = Eigen::Matrix<double, Dim + 1, Dim + 1>;

// The simplex must be an affine basis.
template <int Dim> RowStochastic<Dim> rowStochastic(const Simplex<Dim>& simplex, const AffineMap<Dim>& map);
template <int Dim>
std::vector<RowStochastic<Dim>> rowStochastic(const Simplex<Dim>& simplex,
                                              std::span<const AffineMap<Dim>> maps);

// The map back; over another simplex, the same matrix is the map carried along with the simplex.
template <int Dim> AffineMap<Dim> affineMap(const Simplex<Dim>& simplex, const RowStochastic<Dim>& matrix);

// Returns true if w takes the simplex into itself (to 1e-12). If all maps do, it contains the attractor.
template <int Dim> bool isNonNegative(const RowStochastic<Dim>& matrix);

} // namespace ifs
