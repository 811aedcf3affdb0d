// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace ifs {

// A⁻¹ of a square matrix of any size; not finite where it is singular.
Eigen::MatrixXd inverseOf(const Eigen::MatrixXd& square);

// The same in long numbers, for 2×2, 3×3 and 6×6.
template <int Size>
Eigen::Matrix<long double, Size, Size> inverseOf(const Eigen::Matrix<long double, Size, Size>& square);

// The x with Ax = b.
Eigen::VectorXd solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

} // namespace ifs
