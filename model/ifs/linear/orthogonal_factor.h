// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace ifs {

// The Q of A = QR for a square matrix, from reflections: its columns span what those of A span, in their
// order.
Eigen::MatrixXd orthogonalFactor(const Eigen::MatrixXd& square);

// The shortest x of those with the least |Ax − b|.
Eigen::VectorXd shortestSolution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

} // namespace ifs
