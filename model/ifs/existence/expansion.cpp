// SPDX-License-Identifier: MIT
#include "ifs/existence/expansion.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ifs {

namespace {

// A number that is known up to an error, which grows with every operation. What overflows has an infinite
// error, and no sign.
class Enclosure {
public:
    Enclosure() = default;
    Enclosure(double value, double error) : m_value(value), m_error(error) {}

    bool isPositive() const { return m_value > m_error; }
    bool isNegativeOrZero() const { return std::isfinite(m_error) && m_value <= -m_error; }
    Enclosure operator-() const { return {-m_value, m_error}; }
    friend Enclosure operator+(const Enclosure& a, const Enclosure& b) {
        return rounded(a.m_value + b.m_value, a.m_error + b.m_error);
    }
    friend Enclosure operator-(const Enclosure& a, const Enclosure& b) { return a + -b; }
    friend Enclosure operator*(const Enclosure& a, const Enclosure& b) {
        return rounded(a.m_value * b.m_value, std::abs(a.m_value) * b.m_error +
                                                  std::abs(b.m_value) * a.m_error + a.m_error * b.m_error);
    }

private:
    // Adds the rounding error of the value, and a little for that of the errors themselves.
    static Enclosure rounded(double value, double error) {
        return {value, error * (1 + 0x1p-48) + std::abs(value) * 0x1p-52 + 0x1p-1000};
    }

    double m_value = 0, m_error = 0;
};

template <class Number, int Dim> using Entries = std::array<std::array<Number, Dim>, Dim>;

template <class Number> Number minor(const Entries<Number, 3>& m, std::size_t i, std::size_t k) {
    return m[i][i] * m[k][k] - m[i][k] * m[k][i];
}

// Margins that are all positive if and only if ρ < 1.
template <class Number> std::array<Number, 3> margins(const Entries<Number, 2>& m, const Number& one) {
    const Number trace = m[0][0] + m[1][1], det = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    return {one - det, one + det - trace, one + det + trace};
}

// Trace, sum of the principal minors, determinant.
template <class Number> std::array<Number, 3> characteristic(const Entries<Number, 3>& m) {
    return {m[0][0] + m[1][1] + m[2][2], minor(m, 0, 1) + minor(m, 0, 2) + minor(m, 1, 2),
            m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])};
}

template <class Number> std::array<Number, 6> margins(const Entries<Number, 3>& m, const Number& one) {
    const auto [trace, minors, det] = characteristic(m);
    const Number inner = minors - det * trace, square = one - det * det;
    return {one - trace + minors - det,
            one + trace + minors + det,
            one - det,
            one + det,
            square - inner,
            square + inner};
}

} // namespace

template <int Dim> Expansion expansion(const Matrix<Dim>& linear, double error) {
    Entries<Enclosure, Dim> entries;
    for (int i = 0; i < Dim; ++i)
        for (int j = 0; j < Dim; ++j)
            entries[std::size_t(i)][std::size_t(j)] = {linear(i, j), error};
    const auto known = margins<Enclosure>(entries, {1, 0});
    if (std::ranges::any_of(known, &Enclosure::isNegativeOrZero)) return Expansion::Yes;
    return std::ranges::all_of(known, &Enclosure::isPositive) ? Expansion::No : Expansion::Unknown;
}

template <int Dim> Expansion exactExpansion(const ExactMatrix<Dim>& product) {
    const auto known = margins<Dyadic>(product, Dyadic(1));
    return std::ranges::all_of(known, [](const Dyadic& margin) { return margin.sign() > 0; })
               ? Expansion::No
               : Expansion::Yes;
}

template <int Dim> double radiusOf(const ExactMatrix<Dim>& product) {
    Matrix<Dim> companion = Matrix<Dim>::Zero();
    if constexpr (Dim == 2) {
        const Dyadic det = product[0][0] * product[1][1] - product[0][1] * product[1][0];
        companion << (product[0][0] + product[1][1]).rounded(), -det.rounded(), 1, 0;
    } else {
        const auto [trace, minors, det] = characteristic(product);
        companion << trace.rounded(), -minors.rounded(), det.rounded(), 1, 0, 0, 0, 1, 0;
    }
    return spectralRadius<Dim>(companion);
}

template <int Dim>
Expansion exactExpansion(std::span<const AffineMap<Dim>> maps, const std::vector<int>& word) {
    auto product = exactMatrix<Dim>(Matrix<Dim>::Identity());
    for (const int symbol : word)
        product = product * exactMatrix<Dim>(maps[std::size_t(symbol)].linear);
    return exactExpansion<Dim>(product);
}

template Expansion expansion<2>(const Matrix<2>&, double);
template Expansion expansion<3>(const Matrix<3>&, double);
template double radiusOf<2>(const ExactMatrix<2>&);
template double radiusOf<3>(const ExactMatrix<3>&);
template Expansion exactExpansion<2>(const ExactMatrix<2>&);
template Expansion exactExpansion<3>(const ExactMatrix<3>&);
template Expansion exactExpansion<2>(std::span<const AffineMap<2>>, const std::vector<int>&);
template Expansion exactExpansion<3>(std::span<const AffineMap<3>>, const std::vector<int>&);

} // namespace ifs
