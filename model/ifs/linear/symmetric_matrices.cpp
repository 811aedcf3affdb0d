// SPDX-License-Identifier: MIT
#include "ifs/linear/symmetric_matrices.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace ifs {

namespace {

// Does the work of compute() for a 2×2 matrix, which is tridiagonal as it is: the reflections that would make
// it so take long to compile.
template <class Real>
void solve(Eigen::SelfAdjointEigenSolver<Eigen::Matrix<Real, 2, 2>>& solver,
           Eigen::Matrix<Real, 2, 2> symmetric, Real& scale, int options) {
    symmetric(0, 1) = 0;
    scale = symmetric.cwiseAbs().maxCoeff();
    if (scale == 0) scale = 1;
    const Eigen::Matrix<Real, 2, 1> diagonal = symmetric.diagonal() / scale;
    const Eigen::Matrix<Real, 1, 1> below(symmetric(1, 0) / scale);
    solver.computeFromTridiagonal(diagonal, below, options);
}

template <class Real>
void solve(Eigen::SelfAdjointEigenSolver<Eigen::Matrix<Real, 3, 3>>& solver,
           const Eigen::Matrix<Real, 3, 3>& symmetric, Real& scale, int options) {
    scale = 1;
    solver.compute(symmetric, options);
}

} // namespace

template <int Dim>
SymmetricEigenvalues<Dim> symmetricEigenvalues(const Eigen::Matrix<double, Dim, Dim>& symmetric) {
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, Dim, Dim>> solver;
    double scale = 1;
    solve(solver, symmetric, scale, Eigen::ComputeEigenvectors);
    return {solver.eigenvalues() * scale, solver.eigenvectors()};
}

template <int Dim>
long double leastSymmetricEigenvalue(const Eigen::Matrix<long double, Dim, Dim>& symmetric) {
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix<long double, Dim, Dim>> solver;
    long double scale = 1;
    solve(solver, symmetric, scale, Eigen::EigenvaluesOnly);
    return solver.eigenvalues()[0] * scale;
}

template <int Dim>
std::optional<Eigen::Matrix<double, Dim, Dim>>
choleskyFactor(const Eigen::Matrix<double, Dim, Dim>& symmetric) {
    const Eigen::LLT<Eigen::Matrix<double, Dim, Dim>> cholesky(symmetric);
    if (cholesky.info() != Eigen::Success) return std::nullopt;
    return Eigen::Matrix<double, Dim, Dim>(cholesky.matrixU());
}

template SymmetricEigenvalues<2> symmetricEigenvalues(const Eigen::Matrix2d&);
template SymmetricEigenvalues<3> symmetricEigenvalues(const Eigen::Matrix3d&);
template std::optional<Eigen::Matrix2d> choleskyFactor(const Eigen::Matrix2d&);
template std::optional<Eigen::Matrix3d> choleskyFactor(const Eigen::Matrix3d&);
template long double leastSymmetricEigenvalue(const Eigen::Matrix<long double, 2, 2>&);
template long double leastSymmetricEigenvalue(const Eigen::Matrix<long double, 3, 3>&);

} // namespace ifs
