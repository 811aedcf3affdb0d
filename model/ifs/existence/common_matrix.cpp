// SPDX-License-Identifier: MIT
#include "ifs/existence/common_matrix.h"

#include "ifs/existence/expansion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ifs {

// A norm for one matrix. With ρ(A) < ρ' = 1/(1 + g) and γ = 1 − g/2: the norm √(xᵀPx), P = Σ γ⁻²ⁿ(Aⁿ)ᵀAⁿ,
// contracts by γ. A Schur form D + N has |D| ≤ ρ', |N| ≤ m and Nᵈ = 0, so |Aⁿ| is at most the sum over j < d
// of C(n, j) ρ'ⁿ⁻ʲ mʲ.
template <int Dim> std::optional<CommonMatrixNorm> exactMatrixNorm(const ExactMatrix<Dim>& linear) {
    if (exactExpansion<Dim>(linear) != Expansion::No) return std::nullopt;
    const double size = rounded<Dim>(linear).norm() * (1 + 0x1p-48) + 0x1p-1000;
    for (int digits = 1; digits <= 52; ++digits) { // limit at which γ still is a double
        const double gap = std::ldexp(1, -digits);
        ExactMatrix<Dim> stretched = linear;
        for (auto& row : stretched)
            for (Dyadic& entry : row)
                entry = entry * Dyadic(1 + gap);
        if (exactExpansion<Dim>(stretched) != Expansion::No) continue;
        const double rate = std::log1p(gap / 2 - gap * gap / 2) / 2;      // (ρ'/γ)ⁿ = e^(−2n·rate)
        const double slope = size * (1 + gap) / (std::numbers::e * rate); // of n·m/ρ' e^(−n·rate)
        double largest = 1 + slope;
        if (Dim == 3) largest += 2 * slope * slope;
        const double equivalence = largest / std::sqrt(rate) * (1 + 1e-12);
        if (!std::isfinite(equivalence)) break;
        return CommonMatrixNorm{1 - gap / 2, equivalence};
    }
    return CommonMatrixNorm{1, std::numeric_limits<double>::infinity()};
}

template <int Dim> std::optional<CommonMatrixNorm> commonMatrixNorm(std::span<const AffineMap<Dim>> maps) {
    const Matrix<Dim>& first = maps.front().linear;
    if (!std::ranges::all_of(
            maps, [&](const AffineMap<Dim>& map) { return map.linear == first || map.linear == -first; }))
        return std::nullopt;
    return exactMatrixNorm<Dim>(exactMatrix<Dim>(first));
}

template std::optional<CommonMatrixNorm> exactMatrixNorm<2>(const ExactMatrix<2>&);
template std::optional<CommonMatrixNorm> exactMatrixNorm<3>(const ExactMatrix<3>&);
template std::optional<CommonMatrixNorm> commonMatrixNorm(std::span<const AffineMap<2>>);
template std::optional<CommonMatrixNorm> commonMatrixNorm(std::span<const AffineMap<3>>);

} // namespace ifs
