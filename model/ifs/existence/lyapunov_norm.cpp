// SPDX-License-Identifier: MIT
#include "ifs/existence/lyapunov_norm.h"

#include "ifs/existence/exact_matrix.h"
#include "ifs/existence/symmetric_square.h"

#include <array>
#include <bit>
#include <cmath>

namespace ifs {

namespace {

template <std::size_t Size> using Square = std::array<std::array<Dyadic, Size>, Size>;

// Row by row, from the minors of the rows before in every set of columns: without a division.
template <std::size_t Size> Dyadic determinant(const Square<Size>& m) {
    std::array<Dyadic, (1u << Size)> minors;
    minors[0] = Dyadic(1);
    for (unsigned columns = 1; columns < minors.size(); ++columns) {
        const auto row = std::size_t(std::popcount(columns)) - 1;
        for (std::size_t k = 0; k < Size; ++k) {
            if ((columns >> k & 1u) == 0) continue;
            const Dyadic term = m[row][k] * minors[columns & ~(1u << k)];
            const bool isOdd = std::popcount(columns >> (k + 1)) % 2 == 1;
            minors[columns] = isOdd ? minors[columns] - term : minors[columns] + term;
        }
    }
    return minors.back();
}

template <int Dim> bool isPositiveDefinite(const ExactMatrix<Dim>& m) {
    const Dyadic second = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    return m[0][0].sign() > 0 && second.sign() > 0 && (Dim == 2 || determinant(m).sign() > 0);
}

template <int Dim> ExactMatrix<Dim> transposed(const ExactMatrix<Dim>& m) {
    ExactMatrix<Dim> result;
    for (std::size_t i = 0; i < Dim; ++i)
        for (std::size_t j = 0; j < Dim; ++j)
            result[i][j] = m[j][i];
    return result;
}

// a − factor·b
template <int Dim>
ExactMatrix<Dim> difference(const ExactMatrix<Dim>& a, const Dyadic& factor, const ExactMatrix<Dim>& b) {
    ExactMatrix<Dim> result;
    for (std::size_t i = 0; i < Dim; ++i)
        for (std::size_t j = 0; j < Dim; ++j)
            result[i][j] = a[i][j] - factor * b[i][j];
    return result;
}

// A positive multiple of P, by Cramer's rule; the zero matrix where there is no P.
template <int Dim> ExactMatrix<Dim> form(const std::vector<ExactMatrix<Dim>>& maps, double weight) {
    constexpr auto size = std::size_t(symmetricSize<Dim>);
    Square<size> equations;
    std::array<Dyadic, size> identity;
    for (std::size_t column = 0, a = 0; a < Dim; ++a)
        for (std::size_t b = a; b < Dim; ++b, ++column) {
            identity[column] = Dyadic(a == b ? 1 : 0);
            for (std::size_t row = 0, i = 0; i < Dim; ++i)
                for (std::size_t j = i; j < Dim; ++j, ++row) { // (AᵀPA)_ij for the unit P of a and b
                    Dyadic sum;
                    for (const auto& m : maps)
                        sum = sum + m[a][i] * m[b][j] + (a == b ? Dyadic() : m[b][i] * m[a][j]);
                    equations[row][column] = Dyadic(row == column ? 1 : 0) - Dyadic(weight) * sum;
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

// The g with (1 + g)²AᵀPA < P for all of them, a power of two; 0 where there is none that a double can use.
template <int Dim> double gapOf(const std::vector<ExactMatrix<Dim>>& maps, const ExactMatrix<Dim>& form) {
    constexpr int maxDigits = 52;
    int digits = 1;
    for (const auto& m : maps) {
        const ExactMatrix<Dim> image = transposed<Dim>(m) * form * m;
        for (;; ++digits) {
            if (digits > maxDigits) return 0;
            const Dyadic stretch = Dyadic(1) + Dyadic(std::ldexp(1, -digits));
            if (isPositiveDefinite<Dim>(difference<Dim>(form, stretch * stretch, image))) break;
        }
    }
    return std::ldexp(1, -digits);
}

} // namespace

template <int Dim> std::optional<CommonMatrixNorm> lyapunovNorm(std::span<const AffineMap<Dim>> maps) {
    constexpr std::size_t maxMaps = 8;
    if (maps.size() > maxMaps) return std::nullopt;
    std::vector<ExactMatrix<Dim>> exact;
    for (const auto& map : maps)
        exact.push_back(exactMatrix<Dim>(map.linear));
    for (double weight = 1; weight * double(maps.size()) > 0.5; weight /= 2) {
        const ExactMatrix<Dim> found = form<Dim>(exact, weight);
        if (!isPositiveDefinite<Dim>(found)) continue;
        const double gap = gapOf<Dim>(exact, found), equivalence = conditionOf<Dim>(found);
        if (gap > 0 && std::isfinite(equivalence)) return CommonMatrixNorm{1 - gap / 2, equivalence};
    }
    return std::nullopt;
}

template std::optional<CommonMatrixNorm> lyapunovNorm(std::span<const AffineMap<2>>);
template std::optional<CommonMatrixNorm> lyapunovNorm(std::span<const AffineMap<3>>);

} // namespace ifs
