// SPDX-License-Identifier: MIT
#include "ifs/eigenvalues.h"

#include <Eigen/Eigenvalues>

namespace ifs {

double largestEigenvalueModulus(const Eigen::MatrixXd& square) {
    return Eigen::EigenSolver<Eigen::MatrixXd>(square, false).eigenvalues().cwiseAbs().maxCoeff();
}

} // namespace ifs
