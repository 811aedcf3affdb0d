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

// Of a 2×2 or 3×3 matrix.
template <int Dim> SingularVectors<Dim> singularVectors(const Eigen::Matrix<double, Dim, Dim>& matrix);

// The directions in which columns extend, widest first, at right angles to each other, and the singular
// values; those of no column are 0.
struct PrincipalAxes {
    Eigen::Matrix3d directions;
    Eigen::Vector3d lengths;
};
PrincipalAxes principalAxes(const Eigen::Matrix3Xd& columns);

} // namespace ifs
