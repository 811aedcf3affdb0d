// SPDX-License-Identifier: MIT
#include "ifs/existence/lyapunov_norm.h"

#include "ifs/existence/exact_matrix.h"
#include "ifs/existence/symmetric_square.h"

#include <array>
#include <cmath>
#include <vector>

namespace ifs {

namespace {

template <std::size_t Size> using Square = std::array<std::array<Dyadic, Size>, Size>;

// A positive multiple of P, by Cramer's rule; the zero matrix where there is no P.
template <int Dim>
ExactMatrix<Dim> form(const std::vector<ExactMatrix<Dim>>& maps, const std::vector<double>& weights) {
    constexpr auto size = std::size_t(symmetricSize<Dim>);
    Square<size> equations;
    std::array<Dyadic, size> identity;
    for (std::size_t column = 0, a = 0; a < Dim; ++a)
        for (std::size_t b = a; b < Dim; ++b, ++column) {
            identity[column] = Dyadic(a == b ? 1 : 0);
            for (std::size_t row = 0, i = 0; i < Dim; ++i)
                for (std::size_t j = i; j < Dim; ++j, ++row) { // (AᵀPA)_ij for the unit P of a and b
                    Dyadic sum;
                    for (std::size_t k = 0; k < maps.size(); ++k) {
                        if (weights[k] == 0) continue;
                        const ExactMatrix<Dim>& m = maps[k];
                        const Dyadic mixed = a == b ? Dyadic() : m[b][i] * m[a][j];
                        sum = sum + Dyadic(weights[k]) * (m[a][i] * m[b][j] + mixed);
                    }
                    equations[row][column] = Dyadic(row == column ? 1 : 0) - sum;
                }
        }
    const bool isNegative = determinant(equations).sign() < 0;
    ExactMatrix<Dim> result;
    for (std::size_t column = 0, a = 0; a < Dim; ++a)
        for (std::size_t b = a; b < Dim; ++b, ++column) {
            Square<size> replaced = equations;
            for (std::size_t row = 0; row < size; ++row)
                replaced[row][column] = identity[row];
            const Dyadic entry = determinant(replaced);
            result[a][b] = result[b][a] = isNegative ? -entry : entry;
        }
    return result;
}

// The square root of λ₁/λ_m ≤ (tr P)ᵐ/det P.
template <int Dim> double conditionOf(const ExactMatrix<Dim>& form) {
    Dyadic trace, power(1);
    for (std::size_t k = 0; k < Dim; ++k)
        trace = trace + form[k][k];
    for (int k = 0; k < Dim; ++k)
        power = power * trace;
    return std::sqrt(roundedQuotient(power, determinant(form))) * (1 + 1e-12);
}

// The g with (1 + g)²AᵀPA < P for all of them, a power of two; 0 where all AᵀPA < P and no g is a double that
// can be used, nullopt where they are not.
template <int Dim>
std::optional<double> gapOf(const std::vector<ExactMatrix<Dim>>& maps, const ExactMatrix<Dim>& form) {
    constexpr int maxDigits = 52;
    int digits = 1;
    for (const auto& m : maps) {
        const ExactMatrix<Dim> image = transposed(m) * form * m;
        if (!isPositiveDefinite(difference(form, Dyadic(1), image))) return std::nullopt;
        for (; digits <= maxDigits; ++digits) {
            const Dyadic stretch = Dyadic(1) + Dyadic(std::ldexp(1, -digits));
            if (isPositiveDefinite(difference(form, stretch * stretch, image))) break;
        }
    }
    return digits > maxDigits ? 0 : std::ldexp(1, -digits);
}

template <int Dim>
std::optional<CommonMatrixNorm> normOf(const std::vector<ExactMatrix<Dim>>& maps,
                                       const ExactMatrix<Dim>& form) {
    if (!isPositiveDefinite(form)) return std::nullopt;
    const auto gap = gapOf<Dim>(maps, form);
    if (!gap) return std::nullopt;
    const double equivalence = conditionOf<Dim>(form);
    return CommonMatrixNorm{std::isfinite(equivalence) ? 1 - *gap / 2 : 1, equivalence};
}

template <int Dim> std::vector<ExactMatrix<Dim>> exactParts(std::span<const AffineMap<Dim>> maps) {
    std::vector<ExactMatrix<Dim>> result;
    for (const auto& map : maps)
        result.push_back(exactMatrix<Dim>(map.linear));
    return result;
}

constexpr std::size_t maxMapsOfForm = 8;

} // namespace

template <int Dim>
std::optional<CommonMatrixNorm> ellipsoidNorm(std::span<const AffineMap<Dim>> maps,
                                              const Matrix<Dim>& symmetric) {
    if (maps.size() > maxMapsOfForm || !symmetric.allFinite()) return std::nullopt;
    return normOf<Dim>(exactParts<Dim>(maps), exactMatrix<Dim>(symmetric));
}

template <int Dim> std::optional<CommonMatrixNorm> lyapunovNorm(std::span<const AffineMap<Dim>> maps) {
    if (maps.size() > maxMapsOfForm) return std::nullopt;
    const auto exact = exactParts<Dim>(maps);
    std::vector<std::vector<double>> weights;
    for (double weight = 1; weight * double(maps.size()) > 0.5; weight /= 2)
        weights.emplace_back(maps.size(), weight);
    for (std::size_t k = 0; k < maps.size() && maps.size() > 1; ++k) {
        weights.emplace_back(maps.size(), 0.0);
        weights.back()[k] = 1;
    }
    std::optional<CommonMatrixNorm> slow;
    for (const auto& weight : weights) {
        const auto norm = normOf<Dim>(exact, form<Dim>(exact, weight));
        if (norm && norm->contractivity < 1) return norm;
        if (norm) slow = norm;
    }
    return slow;
}

template std::optional<CommonMatrixNorm> lyapunovNorm(std::span<const AffineMap<2>>);
template std::optional<CommonMatrixNorm> lyapunovNorm(std::span<const AffineMap<3>>);
template std::optional<CommonMatrixNorm> ellipsoidNorm(std::span<const AffineMap<2>>, const Matrix<2>&);
template std::optional<CommonMatrixNorm> ellipsoidNorm(std::span<const AffineMap<3>>, const Matrix<3>&);

} // namespace ifs
