// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace ifs {

// Largest modulus of an eigenvalue. For a finite square matrix of any size: Eigen's general solver takes long
// to compile, so it is compiled once, here.
double largestEigenvalueModulus(const Eigen::MatrixXd& square);

} // namespace ifs
