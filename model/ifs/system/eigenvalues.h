// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace ifs {

// Largest modulus of an eigenvalue. For a finite square matrix of any size: Eigen's general solver takes long
// to compile, so it is compiled once, here.
double largestEigenvalueModulus(const Eigen::MatrixXd& square);

// With its condition: a change of the matrix by e moves the eigenvalue by about condition·e. Infinite where
// eigenvectors coincide; of several of the same modulus the best conditioned counts.
struct ConditionedModulus {
    double modulus;
    double condition; // ≥ 1
};
ConditionedModulus largestEigenvalue(const Eigen::MatrixXd& square);

} // namespace ifs
