// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <optional>

// Eigen's decompositions take long to compile, so each is compiled once, in this folder.
namespace ifs {

// Largest modulus of an eigenvalue, for a finite square matrix of any size.
double largestEigenvalueModulus(const Eigen::MatrixXd& square);

// With its condition: a change of the matrix by e moves the eigenvalue by about condition·e. Infinite where
// eigenvectors coincide; of several of the same modulus the best conditioned counts.
struct ConditionedModulus {
    double modulus;
    double condition; // ≥ 1
};
ConditionedModulus largestEigenvalue(const Eigen::MatrixXd& square);

// Columns are the eigenvectors of real eigenvalues, and the real and imaginary parts of those of a complex
// pair, of any length. For 2×2 and 3×3; nullopt where the iteration does not settle.
template <int Dim>
std::optional<Eigen::Matrix<double, Dim, Dim>> eigendirections(const Eigen::Matrix<double, Dim, Dim>& square);

} // namespace ifs
