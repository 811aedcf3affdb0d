// SPDX-License-Identifier: MIT
#include "ifs/invariant_form.h"

#include "ifs/eigenvalues.h"
#include "ifs/symmetric_square.h"

#include <Eigen/LU>

#include <cmath>

namespace ifs {

template <int Dim>
std::optional<Matrix<Dim>> invariantForm(std::span<const AffineMap<Dim>> maps, double emphasis) {
    using Operator = SymmetricOperator<Dim>;
    Operator transfer = Operator::Zero();
    for (const auto& map : maps)
        transfer += std::pow(spectralRadius<Dim>(map.linear), emphasis) *
                    symmetricSquare<Dim>(map.linear.transpose());
    if (!transfer.allFinite()) return std::nullopt;
    const double growth = largestEigenvalueModulus(transfer);
    if (!(growth > 0)) return std::nullopt;
    // Inverse iteration beside the largest eigenvalue: it also settles when others have the same modulus.
    const Eigen::MatrixXd resolvent =
        Eigen::MatrixXd(growth * (1 + 1e-9) * Operator::Identity() - transfer).inverse();
    SymmetricVector<Dim> form = upperTriangle<Dim>(Matrix<Dim>::Identity());
    constexpr int Iterations = 4;
    for (int n = 0; n < Iterations; ++n) {
        form = resolvent * form;
        form /= form.cwiseAbs().maxCoeff();
    }
    return form.allFinite() ? std::optional(symmetricMatrix<Dim>(form)) : std::nullopt;
}

template std::optional<Matrix<2>> invariantForm(std::span<const AffineMap<2>>, double);
template std::optional<Matrix<3>> invariantForm(std::span<const AffineMap<3>>, double);

} // namespace ifs
