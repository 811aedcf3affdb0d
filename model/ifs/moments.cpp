// SPDX-License-Identifier: MIT
#include "ifs/moments.h"

#include "ifs/eigenvalues.h"
#include "ifs/symmetric_square.h"

#include <Eigen/LU>

#include <algorithm>

namespace ifs {

template <int Dim> std::optional<Moments<Dim>> moments(const ActiveMaps<Dim>& active) {
    if (active.maps.empty() || !std::ranges::all_of(active.maps, isFinite<Dim>)) return std::nullopt;
    AffineMap<Dim> average{Matrix<Dim>::Zero(), Vector<Dim>::Zero()};
    SymmetricOperator<Dim> transfer = SymmetricOperator<Dim>::Zero();
    for (std::size_t i = 0; i < active.maps.size(); ++i) {
        const double p = active.probabilities[i];
        average.linear += p * active.maps[i].linear;
        average.translation += p * active.maps[i].translation;
        transfer += p * symmetricSquare<Dim>(active.maps[i].linear);
    }
    if (!transfer.allFinite()) return std::nullopt;
    if (!(largestEigenvalueModulus(transfer) < 1)) return std::nullopt;

    const Matrix<Dim> resolvent = (Matrix<Dim>::Identity() - average.linear).inverse();
    Moments<Dim> result;
    result.mean = resolvent * average.translation;
    Matrix<Dim> source = Matrix<Dim>::Zero(); // Σ p_i d_i d_iᵀ with d_i = w_i(mean) − mean
    for (std::size_t i = 0; i < active.maps.size(); ++i) {
        const Vector<Dim> shift = active.maps[i](result.mean) - result.mean;
        source += active.probabilities[i] * shift * shift.transpose();
    }
    const Eigen::MatrixXd complement = SymmetricOperator<Dim>::Identity() - transfer;
    const Eigen::VectorXd upper = upperTriangle<Dim>(source);
    result.covariance = symmetricMatrix<Dim>(complement.partialPivLu().solve(upper).eval());
    const Matrix<Dim> oneSided = resolvent * result.covariance;
    result.longRunCovariance = oneSided + oneSided.transpose() - result.covariance;
    const bool finite = result.mean.allFinite() && result.longRunCovariance.allFinite();
    return finite ? std::optional(result) : std::nullopt;
}

template std::optional<Moments<2>> moments(const ActiveMaps<2>&);
template std::optional<Moments<3>> moments(const ActiveMaps<3>&);

} // namespace ifs
