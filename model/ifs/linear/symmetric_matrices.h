// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <optional>

namespace ifs {

// A = vectors·diag(values)·vectorsᵀ, values smallest first, vectors of length 1.
template <int Dim> struct SymmetricEigenvalues {
    Eigen::Matrix<double, Dim, 1> values;
    Eigen::Matrix<double, Dim, Dim> vectors;
};

// The eigenvalues of a symmetric 2×2 or 3×3 matrix, of which only the lower triangle is read.
template <int Dim>
SymmetricEigenvalues<Dim> symmetricEigenvalues(const Eigen::Matrix<double, Dim, Dim>& symmetric);

// The smallest eigenvalue of such a matrix.
template <int Dim>
long double leastSymmetricEigenvalue(const Eigen::Matrix<long double, Dim, Dim>& symmetric);

// The upper triangular U with A = UᵀU; nullopt where the matrix is not positive definite.
template <int Dim>
std::optional<Eigen::Matrix<double, Dim, Dim>>
choleskyFactor(const Eigen::Matrix<double, Dim, Dim>& symmetric);

} // namespace ifs
