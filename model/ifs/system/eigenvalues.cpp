// SPDX-License-Identifier: MIT
#include "ifs/system/eigenvalues.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ifs {

double largestEigenvalueModulus(const Eigen::MatrixXd& square) {
    return Eigen::EigenSolver<Eigen::MatrixXd>(square, false).eigenvalues().cwiseAbs().maxCoeff();
}

ConditionedModulus largestEigenvalue(const Eigen::MatrixXd& square) {
    const Eigen::EigenSolver<Eigen::MatrixXd> solved(square);
    const Eigen::MatrixXcd right = solved.eigenvectors(), left = right.inverse();
    const double modulus = solved.eigenvalues().cwiseAbs().maxCoeff();
    double condition = std::numeric_limits<double>::infinity();
    for (Eigen::Index k = 0; k < square.rows(); ++k)
        if (const double own = right.col(k).norm() * left.row(k).norm();
            std::abs(solved.eigenvalues()[k]) >= modulus * (1 - 1e-14) && own < condition)
            condition = std::max(own, 1.0);
    return {modulus, condition};
}

} // namespace ifs
