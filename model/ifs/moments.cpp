// SPDX-License-Identifier: MIT
#include "ifs/moments.h"

#include "ifs/eigenvalues.h"
#include "ifs/symmetric_square.h"

#include <Eigen/LU>

#include <algorithm>

namespace ifs {

namespace {

// Σ p_i w_i; nullopt when no map is active or one is not finite.
template <int Dim> std::optional<AffineMap<Dim>> meanMap(const ActiveMaps<Dim>& active) {
    if (active.maps.empty() || !std::ranges::all_of(active.maps, isFinite<Dim>)) return std::nullopt;
    AffineMap<Dim> average{Matrix<Dim>::Zero(), Vector<Dim>::Zero()};
    for (std::size_t i = 0; i < active.maps.size(); ++i) {
        average.linear += active.probabilities[i] * active.maps[i].linear;
        average.translation += active.probabilities[i] * active.maps[i].translation;
    }
    return average;
}

template <int Dim> Matrix<Dim> resolvent(const AffineMap<Dim>& average) {
    return (Matrix<Dim>::Identity() - average.linear).inverse();
}

} // namespace

template <int Dim> std::optional<Vector<Dim>> mean(const ActiveMaps<Dim>& active) {
    const auto average = meanMap(active);
    if (!average || !(spectralRadius<Dim>(average->linear) < 1)) return std::nullopt;
    const Vector<Dim> result = resolvent(*average) * average->translation;
    return result.allFinite() ? std::optional(result) : std::nullopt;
}

template <int Dim> std::optional<Moments<Dim>> moments(const ActiveMaps<Dim>& active) {
    const auto average = meanMap(active);
    if (!average) return std::nullopt;
    SymmetricOperator<Dim> transfer = SymmetricOperator<Dim>::Zero();
    for (std::size_t i = 0; i < active.maps.size(); ++i)
        transfer += active.probabilities[i] * symmetricSquare<Dim>(active.maps[i].linear);
    if (!transfer.allFinite()) return std::nullopt;
    if (!(largestEigenvalueModulus(transfer) < 1)) return std::nullopt;

    Moments<Dim> result;
    result.mean = resolvent(*average) * average->translation;
    Matrix<Dim> source = Matrix<Dim>::Zero(); // Σ p_i d_i d_iᵀ with d_i = w_i(mean) − mean
    for (std::size_t i = 0; i < active.maps.size(); ++i) {
        const Vector<Dim> shift = active.maps[i](result.mean) - result.mean;
        source += active.probabilities[i] * shift * shift.transpose();
    }
    const Eigen::MatrixXd complement = SymmetricOperator<Dim>::Identity() - transfer;
    const Eigen::VectorXd upper = upperTriangle<Dim>(source);
    result.covariance = symmetricMatrix<Dim>(complement.partialPivLu().solve(upper).eval());
    const Matrix<Dim> oneSided = resolvent(*average) * result.covariance;
    result.longRunCovariance = oneSided + oneSided.transpose() - result.covariance;
    const bool finite = result.mean.allFinite() && result.longRunCovariance.allFinite();
    return finite ? std::optional(result) : std::nullopt;
}

template std::optional<Vector<2>> mean(const ActiveMaps<2>&);
template std::optional<Vector<3>> mean(const ActiveMaps<3>&);
template std::optional<Moments<2>> moments(const ActiveMaps<2>&);
template std::optional<Moments<3>> moments(const ActiveMaps<3>&);

} // namespace ifs
