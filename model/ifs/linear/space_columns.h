// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

// Matrices of any number of columns in space.
namespace ifs {

// The directions in which columns extend, widest first, at right angles to each other, and the singular
// values; those of no column are 0.
struct PrincipalAxes {
    Eigen::Matrix3d directions;
    Eigen::Vector3d lengths;
};
PrincipalAxes principalAxes(const Eigen::Matrix3Xd& columns);

// An x with the least |Ax − b|.
Eigen::VectorXd leastSquares(const Eigen::Matrix3Xd& columns, const Eigen::Vector3d& b);

} // namespace ifs
