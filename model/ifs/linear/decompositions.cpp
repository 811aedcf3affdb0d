// SPDX-License-Identifier: MIT
#include "ifs/linear/decompositions.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

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

template <int Dim>
std::optional<Eigen::Matrix<double, Dim, Dim>>
eigendirections(const Eigen::Matrix<double, Dim, Dim>& square) {
    using Fixed = Eigen::Matrix<double, Dim, Dim>;
    // Saves an instantiation. Results are identical for 2×2; for 3×3, zeros would change their signs.
    using Solved = std::conditional_t<Dim == 2, Eigen::MatrixXd, Fixed>;
    const Eigen::EigenSolver<Solved> solved{Solved(square)};
    if (solved.info() != Eigen::Success) return std::nullopt;
    return Fixed(solved.pseudoEigenvectors());
}

template std::optional<Eigen::Matrix2d> eigendirections(const Eigen::Matrix2d&);
template std::optional<Eigen::Matrix3d> eigendirections(const Eigen::Matrix3d&);

Eigen::MatrixXd orthogonalFactor(const Eigen::MatrixXd& square) {
    return Eigen::HouseholderQR<Eigen::MatrixXd>(square).householderQ();
}

Eigen::VectorXd shortestSolution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
    return a.completeOrthogonalDecomposition().solve(b);
}

} // namespace ifs
