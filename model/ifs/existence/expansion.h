// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/existence/exact_matrix.h"
#include "ifs/system/affine_map.h"

#include <span>
#include <vector>

namespace ifs {

// Whether ρ(A) ≥ 1, for a matrix whose coefficients are off by at most an error.
enum class Expansion {
    No,      // proved: ρ < 1
    Yes,     // proved: ρ ≥ 1
    Unknown, // undecidable at this error
};

// Decides by the signs that the criterion of Schur and Cohn requires of the coefficients of the
// characteristic polynomial. docs/mathematics.md, "When does a system have an attractor?"
template <int Dim> Expansion expansion(const Matrix<Dim>& linear, double error);

// Decides without rounding whether the product of the maps of a word expands: never Unknown. Slow, some 10 µs
// for each symbol.
template <int Dim>
Expansion exactExpansion(std::span<const AffineMap<Dim>> maps, const std::vector<int>& word);

template <int Dim> Expansion exactExpansion(const ExactMatrix<Dim>& product);

// ρ, from coefficients of the characteristic polynomial that were rounded once.
template <int Dim> double radiusOf(const ExactMatrix<Dim>& product);

} // namespace ifs
