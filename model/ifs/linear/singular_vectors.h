// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace ifs {

// A = left·diag(values)·rightᵀ with orthogonal matrices, values largest first.
template <int Dim> struct SingularVectors {
    Eigen::Matrix<double, Dim, Dim> left;
    Eigen::Matrix<double, Dim, 1> values;
    Eigen::Matrix<double, Dim, Dim> right;
};

// The singular vectors of a 2×2 or 3×3 matrix.
template <int Dim> SingularVectors<Dim> singularVectors(const Eigen::Matrix<double, Dim, Dim>& matrix);

} // namespace ifs
