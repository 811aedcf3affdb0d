// SPDX-License-Identifier: MIT
#include "animation/paths/common_norm.h"

#include "animation/paths/contraction.h"
#include "ifs/existence/invariant_form.h"
#include "ifs/existence/norm_descent.h"
#include "ifs/existence/symmetric_square.h"
#include "ifs/linear/decompositions.h"
#include "ifs/linear/inverse.h"
#include "ifs/linear/symmetric_matrices.h"

#include <algorithm>

namespace animation {

namespace {

// √P and its inverse, if P is definite enough.
template <int Dim> std::optional<CommonNorm<Dim>> rootsOf(const ifs::Matrix<Dim>& form) {
    const auto [values, vectors] = ifs::symmetricEigenvalues<Dim>(form);
    if (!(values.minCoeff() > 1e-12 * values.maxCoeff())) return std::nullopt;
    return CommonNorm<Dim>{vectors * values.cwiseSqrt().asDiagonal() * vectors.transpose(),
                           vectors * values.cwiseInverse().cwiseSqrt().asDiagonal() * vectors.transpose(),
                           false};
}

// The norm √(xᵀPx), if all maps contract there.
template <int Dim>
std::optional<CommonNorm<Dim>> tried(const ifs::Matrix<Dim>& form,
                                     std::span<const ifs::AffineMap<Dim>> maps) {
    const auto norm = rootsOf<Dim>((form + form.transpose()) / 2);
    if (!norm) return std::nullopt;
    const bool serves = std::ranges::all_of(maps, [&](const ifs::AffineMap<Dim>& map) {
        const ifs::Matrix<Dim> seen = norm->root * map.linear * norm->inverse;
        return seen.squaredNorm() < 1 - 3 * safety || ifs::spectralNorm<Dim>(seen) < 1 - safety;
    });
    return serves ? norm : std::nullopt;
}

// P = I + Σ AᵀPA, where the sum of all products converges.
template <int Dim> std::optional<ifs::Matrix<Dim>> sumOfProducts(std::span<const ifs::AffineMap<Dim>> maps) {
    using Operator = ifs::SymmetricOperator<Dim>;
    Operator transfer = Operator::Zero();
    for (const auto& map : maps)
        transfer += ifs::symmetricSquare<Dim>(map.linear.transpose());
    if (!transfer.allFinite() || !(ifs::largestEigenvalueModulus(transfer) < 1 - safety)) return std::nullopt;
    const Eigen::MatrixXd inverse = ifs::inverseOf(Operator::Identity() - transfer);
    const ifs::SymmetricVector<Dim> form = inverse * ifs::upperTriangle<Dim>(ifs::Matrix<Dim>::Identity());
    return ifs::symmetricMatrix<Dim>(form);
}

// Descends from the coordinates of an invariant form to those in which the longest map is as short as it
// gets.
template <int Dim>
std::optional<CommonNorm<Dim>> descended(const ifs::Matrix<Dim>& form,
                                         std::span<const ifs::AffineMap<Dim>> maps) {
    const auto norm = rootsOf<Dim>(form);
    if (!norm) return std::nullopt;
    ifs::NormCoordinates<Dim> best{norm->root, 0};
    for (const auto& map : maps)
        best.longest =
            std::max(best.longest, ifs::spectralNorm<Dim>(norm->root * map.linear * norm->inverse));
    ifs::descend<Dim>(best, maps);
    return tried<Dim>(best.root.transpose() * best.root, maps);
}

} // namespace

template <int Dim> std::optional<CommonNorm<Dim>> commonNorm(std::span<const ifs::AffineMap<Dim>> maps) {
    if (std::ranges::all_of(maps, contracts<Dim>)) return CommonNorm<Dim>{};
    if (!std::ranges::all_of(maps, ifs::isFinite<Dim>)) return std::nullopt;
    // If some map alone contracts in no norm, no norm is common.
    for (const auto& map : maps)
        if (map.linear.squaredNorm() >= 1 - safety && !(ifs::spectralRadius<Dim>(map.linear) < 1))
            return std::nullopt;
    if (const auto form = sumOfProducts(maps))
        if (auto norm = tried<Dim>(*form, maps)) return norm;
    for (const double emphasis : {0.0, 2.0, 8.0}) {
        const auto form = ifs::invariantForm<Dim>(maps, emphasis);
        if (!form) continue;
        if (auto norm = tried<Dim>(*form, maps)) return norm;
        if (auto norm = descended<Dim>(*form, maps)) return norm;
    }
    return std::nullopt;
}

template std::optional<CommonNorm<2>> commonNorm(std::span<const ifs::AffineMap<2>>);
template std::optional<CommonNorm<3>> commonNorm(std::span<const ifs::AffineMap<3>>);

} // namespace animation
