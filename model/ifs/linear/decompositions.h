// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <optional>

// Decompositions of matrices of any size. Eigen's take long to compile, so each is compiled once, in this
// folder, and these in one file, because they share the code of reflections.
namespace ifs {

// Largest modulus of an eigenvalue, for a finite square matrix of any size.
double largestEigenvalueModulus(const Eigen::MatrixXd& square);

// The modulus of an eigenvalue and its condition: a change of the matrix by e moves the eigenvalue by about
// condition·e. Infinite where eigenvectors coincide; among several of the same modulus the best conditioned
// counts.
struct ConditionedModulus {
    double modulus;
    double condition; // ≥ 1
};
ConditionedModulus largestEigenvalue(const Eigen::MatrixXd& square);

// Columns are the eigenvectors of real eigenvalues, and the real and imaginary parts of those of a complex
// pair, of any length. For 2×2 and 3×3; nullopt where the iteration does not settle.
template <int Dim>
std::optional<Eigen::Matrix<double, Dim, Dim>> eigendirections(const Eigen::Matrix<double, Dim, Dim>& square);

// The Q of A = QR for a square matrix, from reflections: its first columns span what those of A span.
Eigen::MatrixXd orthogonalFactor(const Eigen::MatrixXd& square);

// The shortest x of those with the least |Ax − b|.
Eigen::VectorXd shortestSolution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

} // namespace ifs
