// SPDX-License-Identifier: MIT
#include "ifs/existence/support_norm.h"

#include "ifs/existence/exact_matrix.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ifs {

namespace {

constexpr int maxDigits = 52; // digits of the gap 2^−digits; beyond, no double below 1 is a factor

template <int Dim> class Support {
public:
    explicit Support(std::span<const AffineMap<Dim>> maps) : m_largest(Matrix<Dim>::Zero()) {
        for (const auto& map : maps)
            m_largest = m_largest.cwiseMax(map.linear.cwiseAbs());
        for (std::size_t i = 0; i < Dim; ++i)
            for (std::size_t j = 0; j < Dim; ++j)
                m_reached[i][j] = i == j || coefficient(i, j) > 0;
        for (std::size_t via = 0; via < Dim; ++via)
            for (std::size_t i = 0; i < Dim; ++i)
                for (std::size_t j = 0; j < Dim; ++j)
                    m_reached[i][j] = m_reached[i][j] || (m_reached[i][via] && m_reached[via][j]);
        m_isMonomial = std::ranges::all_of(maps, [this](const auto& map) { return isMonomial(map.linear); });
    }

    bool isMonomial() const { return m_isMonomial; }
    double largest() const { return m_largest.maxCoeff(); }

    int components() const {
        int result = 0;
        for (std::size_t i = 0; i < Dim; ++i) {
            bool isFirst = true;
            for (std::size_t j = 0; j < i; ++j)
                isFirst = isFirst && !areTogether(i, j);
            result += isFirst ? 1 : 0;
        }
        return result;
    }

    // Returns true if all cycles of the coefficients times 1 + gap have products below 1.
    bool areCyclesBelowOne(double gap) const {
        const Dyadic stretch = Dyadic(1) + Dyadic(gap);
        std::array<std::array<Dyadic, Dim>, Dim> edge;
        for (std::size_t i = 0; i < Dim; ++i)
            for (std::size_t j = 0; j < Dim; ++j)
                edge[i][j] = Dyadic(coefficient(i, j)) * stretch;
        const auto isBelowOne = [](const Dyadic& product) { return (product - Dyadic(1)).sign() < 0; };
        for (std::size_t i = 0; i < Dim; ++i) {
            if (!isBelowOne(edge[i][i])) return false;
            for (std::size_t j = 0; j < Dim; ++j) {
                if (j == i) continue;
                if (!isBelowOne(edge[i][j] * edge[j][i])) return false;
                const std::size_t k = 3 - i - j; // remaining axis of space
                if (Dim == 3 && !isBelowOne(edge[i][j] * edge[j][k % Dim] * edge[k % Dim][i])) return false;
            }
        }
        return true;
    }

private:
    double coefficient(std::size_t i, std::size_t j) const {
        return m_largest(Eigen::Index(i), Eigen::Index(j));
    }
    bool areTogether(std::size_t i, std::size_t j) const { return m_reached[i][j] && m_reached[j][i]; }

    // True if the map permutes and scales axes within each component.
    bool isMonomial(const Matrix<Dim>& linear) const {
        for (std::size_t i = 0; i < Dim; ++i) {
            int row = 0, column = 0;
            for (std::size_t j = 0; j < Dim; ++j) {
                if (!areTogether(i, j)) continue;
                row += linear(Eigen::Index(i), Eigen::Index(j)) != 0 ? 1 : 0;
                column += linear(Eigen::Index(j), Eigen::Index(i)) != 0 ? 1 : 0;
            }
            if (row > 1 || column > 1) return false;
        }
        return true;
    }

    Matrix<Dim> m_largest;
    std::array<std::array<bool, Dim>, Dim> m_reached{};
    bool m_isMonomial = false;
};

// Returns true if I − (1 + gap)²AᵀA is positive definite, by its leading minors.
template <int Dim> bool isShort(const Matrix<Dim>& linear, double gap) {
    const Dyadic stretch = Dyadic(1) + Dyadic(gap);
    const ExactMatrix<Dim> a = exactMatrix<Dim>(linear);
    ExactMatrix<Dim> rest;
    for (std::size_t i = 0; i < Dim; ++i)
        for (std::size_t j = 0; j < Dim; ++j) {
            Dyadic sum;
            for (std::size_t k = 0; k < Dim; ++k)
                sum = sum + a[k][i] * a[k][j];
            rest[i][j] = Dyadic(i == j ? 1 : 0) - sum * stretch * stretch;
        }
    return isPositiveDefinite(rest);
}

} // namespace

// A norm from the pattern of nonzero coefficients. With μ = 1/(1 + g) above the geometric mean of every
// cycle, v_i is the largest product of |a|/μ along a walk from i, or 1: then |a_ij| v_j ≤ μ v_i, and simple
// walks bound v_i by V. Stretched by ε from component to component, in the order in which they lead to one
// another, the rest has a norm below Dim·ε·M·V = g/4, M the largest coefficient, and μ + g/4 < 1 − g/2.
template <int Dim> std::optional<CommonMatrixNorm> supportNorm(std::span<const AffineMap<Dim>> maps) {
    const Support<Dim> support(maps);
    if (!support.isMonomial() || !support.areCyclesBelowOne(0)) return std::nullopt;
    for (int digits = 2; digits <= maxDigits; ++digits) {
        const double gap = std::ldexp(1, -digits);
        if (!support.areCyclesBelowOne(gap)) continue;
        const double largest = std::max(1.0, support.largest());
        const double walk = std::pow(2 * largest, Dim - 1), step = 4 * Dim * largest * walk / gap;
        const double equivalence = walk * std::pow(step, support.components() - 1) * (1 + 1e-12);
        if (!std::isfinite(equivalence)) break;
        return CommonMatrixNorm{1 - gap / 2, equivalence};
    }
    return CommonMatrixNorm{1, std::numeric_limits<double>::infinity()};
}

template <int Dim> std::optional<CommonMatrixNorm> exactEuclideanNorm(std::span<const AffineMap<Dim>> maps) {
    constexpr std::size_t maxMaps = 1'000;
    if (maps.size() > maxMaps) return std::nullopt;
    int digits = 1;
    for (const auto& map : maps) {
        if (!(map.linear.cwiseAbs().maxCoeff() <= 1) || !isShort<Dim>(map.linear, 0)) return std::nullopt;
        while (digits <= maxDigits && !isShort<Dim>(map.linear, std::ldexp(1, -digits)))
            ++digits;
    }
    return CommonMatrixNorm{digits > maxDigits ? 1 : 1 - std::ldexp(1, -digits - 1), 1};
}

template std::optional<CommonMatrixNorm> supportNorm(std::span<const AffineMap<2>>);
template std::optional<CommonMatrixNorm> supportNorm(std::span<const AffineMap<3>>);
template std::optional<CommonMatrixNorm> exactEuclideanNorm(std::span<const AffineMap<2>>);
template std::optional<CommonMatrixNorm> exactEuclideanNorm(std::span<const AffineMap<3>>);

} // namespace ifs
