// SPDX-License-Identifier: MIT
#include "ifs/existence/invariant_form.h"

#include "ifs/existence/symmetric_square.h"
#include "ifs/linear/decompositions.h"
#include "ifs/linear/inverse.h"

#include <cmath>

namespace ifs {

template <int Dim>
std::optional<Matrix<Dim>> invariantForm(std::span<const AffineMap<Dim>> maps, double emphasis) {
    std::vector<double> weights;
    for (const auto& map : maps)
        weights.push_back(std::pow(spectralRadius<Dim>(map.linear), emphasis));
    return invariantForm(maps, weights);
}

template <int Dim>
std::optional<Matrix<Dim>> invariantForm(std::span<const AffineMap<Dim>> maps,
                                         const std::vector<double>& weights) {
    using Operator = SymmetricOperator<Dim>;
    Operator transfer = Operator::Zero();
    for (std::size_t i = 0; i < maps.size(); ++i)
        transfer += weights[i] * symmetricSquare<Dim>(maps[i].linear.transpose());
    if (!transfer.allFinite()) return std::nullopt;
    const double growth = largestEigenvalueModulus(transfer);
    if (!(growth > 0)) return std::nullopt;
    // Inverse iteration close to the largest eigenvalue, which converges even if others have the same
    // modulus.
    const Eigen::MatrixXd resolvent = inverseOf(growth * (1 + 1e-9) * Operator::Identity() - transfer);
    SymmetricVector<Dim> form = upperTriangle<Dim>(Matrix<Dim>::Identity());
    constexpr int iterations = 4;
    for (int n = 0; n < iterations; ++n) {
        form = resolvent * form;
        form /= form.cwiseAbs().maxCoeff();
    }
    return form.allFinite() ? std::optional(symmetricMatrix<Dim>(form)) : std::nullopt;
}

template std::optional<Matrix<2>> invariantForm(std::span<const AffineMap<2>>, double);
template std::optional<Matrix<3>> invariantForm(std::span<const AffineMap<3>>, double);
template std::optional<Matrix<2>> invariantForm(std::span<const AffineMap<2>>, const std::vector<double>&);
template std::optional<Matrix<3>> invariantForm(std::span<const AffineMap<3>>, const std::vector<double>&);

} // namespace ifs
