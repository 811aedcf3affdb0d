// SPDX-License-Identifier: MIT
#include "ifs/linear/orthogonal_factor.h"

#include <Eigen/QR>

namespace ifs {

Eigen::MatrixXd orthogonalFactor(const Eigen::MatrixXd& square) {
    return Eigen::HouseholderQR<Eigen::MatrixXd>(square).householderQ();
}

Eigen::VectorXd shortestSolution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
    return a.completeOrthogonalDecomposition().solve(b);
}

} // namespace ifs
