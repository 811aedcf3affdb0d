// SPDX-License-Identifier: MIT
#include "ifs/separation/exact_map.h"

#include "ifs/existence/exact_matrix.h"

#include <cmath>
#include <limits>

namespace ifs {

namespace {

template <int Dim> using Entries = std::array<std::array<Dyadic, Dim>, Dim>;

template <int Dim> std::array<Dyadic, Dim> product(const Entries<Dim>& m, const std::array<Dyadic, Dim>& x) {
    std::array<Dyadic, Dim> result;
    for (std::size_t i = 0; i < Dim; ++i)
        for (std::size_t j = 0; j < Dim; ++j)
            result[i] = result[i] + m[i][j] * x[j];
    return result;
}

} // namespace

template <int Dim> ExactMap<Dim> exactWord(std::span<const AffineMap<Dim>> maps, const Word& word) {
    ExactMap<Dim> result;
    for (std::size_t i = 0; i < Dim; ++i)
        result.linear[i][i] = Dyadic(1);
    for (const int symbol : word) {
        const AffineMap<Dim>& map = maps[std::size_t(symbol)];
        Entries<Dim> factor;
        std::array<Dyadic, Dim> shift;
        for (int i = 0; i < Dim; ++i) {
            shift[std::size_t(i)] = Dyadic(map.translation[i]);
            for (int j = 0; j < Dim; ++j)
                factor[std::size_t(i)][std::size_t(j)] = Dyadic(map.linear(i, j));
        }
        const auto moved = product<Dim>(result.linear, shift);
        Entries<Dim> linear;
        for (std::size_t i = 0; i < Dim; ++i) {
            result.translation[i] = result.translation[i] + moved[i];
            for (std::size_t j = 0; j < Dim; ++j)
                for (std::size_t k = 0; k < Dim; ++k)
                    linear[i][j] = linear[i][j] + result.linear[i][k] * factor[k][j];
        }
        result.linear = linear;
    }
    return result;
}

// The fixed point by Cramer's rule from (I − A)x = b.
template <int Dim> ExactPoint<Dim> exactFixedPoint(const ExactMap<Dim>& map) {
    Entries<Dim> complement;
    for (std::size_t i = 0; i < Dim; ++i)
        for (std::size_t j = 0; j < Dim; ++j)
            complement[i][j] = Dyadic(i == j ? 1 : 0) - map.linear[i][j];
    ExactPoint<Dim> result;
    result.denominator = determinant(complement);
    for (std::size_t k = 0; k < Dim; ++k) {
        Entries<Dim> replaced = complement;
        for (std::size_t i = 0; i < Dim; ++i)
            replaced[i][k] = map.translation[i];
        result.numerator[k] = determinant(replaced);
    }
    return result;
}

template <int Dim> ExactPoint<Dim> image(const ExactMap<Dim>& map, const ExactPoint<Dim>& point) {
    ExactPoint<Dim> result{product<Dim>(map.linear, point.numerator), point.denominator};
    for (std::size_t k = 0; k < Dim; ++k)
        result.numerator[k] = result.numerator[k] + point.denominator * map.translation[k];
    return result;
}

template <int Dim> bool isSame(const ExactPoint<Dim>& a, const ExactPoint<Dim>& b) {
    if (a.denominator.sign() == 0 || b.denominator.sign() == 0) return false;
    for (std::size_t k = 0; k < Dim; ++k)
        if (!(a.numerator[k] * b.denominator == b.numerator[k] * a.denominator)) return false;
    return true;
}

template <int Dim> bool haveCommonFixedPoint(std::span<const AffineMap<Dim>> maps) {
    if (maps.empty()) return false;
    const auto point = exactFixedPoint(exactWord<Dim>(maps, {0}));
    for (int i = 0; i < int(maps.size()); ++i)
        if (!isSame(point, image(exactWord<Dim>(maps, {i}), point))) return false;
    return true;
}

template <int Dim> std::optional<Mean<Dim>> commonFixedPoint(std::span<const AffineMap<Dim>> maps) {
    if (!haveCommonFixedPoint<Dim>(maps)) return std::nullopt;
    constexpr double ofQuotient = 0x1p-50, least = std::numeric_limits<double>::denorm_min();
    const auto exact = exactFixedPoint(exactWord<Dim>(maps, {0}));
    Mean<Dim> result{Vector<Dim>::Zero()};
    for (std::size_t k = 0; k < Dim; ++k) {
        const double seen = roundedQuotient(exact.numerator[k], exact.denominator) + 0.0;
        if (!std::isfinite(seen)) return std::nullopt;
        result.point[Eigen::Index(k)] = seen;
        const Dyadic off = exact.numerator[k] - Dyadic(seen) * exact.denominator;
        if (off.sign() != 0)
            result.error += std::abs(roundedQuotient(off, exact.denominator)) * (1 + ofQuotient) + least;
    }
    return std::isfinite(result.error) ? std::optional(result) : std::nullopt;
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template ExactMap<Dim> exactWord(std::span<const AffineMap<Dim>>, const Word&);                          \
    template ExactPoint<Dim> exactFixedPoint(const ExactMap<Dim>&);                                          \
    template ExactPoint<Dim> image(const ExactMap<Dim>&, const ExactPoint<Dim>&);                            \
    template bool isSame(const ExactPoint<Dim>&, const ExactPoint<Dim>&);                                    \
    template bool haveCommonFixedPoint(std::span<const AffineMap<Dim>>);                                     \
    template std::optional<Mean<Dim>> commonFixedPoint(std::span<const AffineMap<Dim>>);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace ifs
