// SPDX-License-Identifier: MIT
#include "ifs/separation/determinant_sum.h"

#include "ifs/existence/exact_matrix.h"
#include "ifs/separation/affine_hull.h"
#include "ifs/separation/stored_rounding.h"

#include <cstddef>

namespace ifs {

template <int Dim> Dyadic excessOfDeterminants(std::span<const AffineMap<Dim>> maps) {
    Dyadic result(-1);
    for (const auto& map : maps) {
        const Dyadic det = determinant(exactMatrix<Dim>(map.linear));
        result = det.sign() < 0 ? result - det : result + det;
    }
    return result;
}

template <int Dim> bool fillSpace(std::span<const AffineMap<Dim>> maps) {
    return excessOfDeterminants<Dim>(maps).sign() >= 0;
}

namespace {

Dyadic absolute(const Dyadic& number) {
    return number.sign() < 0 ? -number : number;
}

// The coordinates at the pivots, of which a hull has as many as dimensions, less than those of space.
template <int Dim> class OnHull {
public:
    explicit OnHull(const HullBasis<Dim>& basis) : m_basis(basis) {}

    // |det| of A on the hull, times that of the basis.
    Dyadic determinantOf(const ExactMatrix<Dim>& linear) const {
        const auto entry = [&](std::size_t row, std::size_t column) {
            Dyadic sum;
            for (std::size_t k = 0; k < Dim; ++k)
                sum = sum + linear[pivot(row)][k] * way(column)[k];
            return sum;
        };
        if (m_basis.directions.size() == 1) return absolute(entry(0, 0));
        return absolute(entry(0, 0) * entry(1, 1) - entry(0, 1) * entry(1, 0));
    }

    // The sum of the sizes of the products that it is made of.
    Dyadic termsOf(const ExactMatrix<Dim>& linear) const {
        const auto entry = [&](std::size_t row, std::size_t column) {
            Dyadic sum;
            for (std::size_t k = 0; k < Dim; ++k)
                sum = sum + absolute(linear[pivot(row)][k] * way(column)[k]);
            return sum;
        };
        if (m_basis.directions.size() == 1) return entry(0, 0);
        return entry(0, 0) * entry(1, 1) + entry(0, 1) * entry(1, 0);
    }

private:
    std::size_t pivot(std::size_t k) const { return m_basis.directions[k].pivot; }
    const auto& way(std::size_t k) const { return m_basis.directions[k].way; }

    const HullBasis<Dim>& m_basis;
};

} // namespace

template <int Dim> std::optional<HullExcess> excessOnHull(std::span<const AffineMap<Dim>> maps) {
    const auto basis = hullBasis<Dim>(maps);
    if (!basis) return std::nullopt;
    HullExcess result{int(basis->directions.size())};
    if (result.dimension == 0) { // all determinants are 1
        result.value = double(maps.size()) - 1;
        return result;
    }
    if (result.dimension == Dim) {
        result.value = excessOfDeterminants<Dim>(maps).rounded();
        for (const auto& map : maps)
            result.rounding += offDeterminant<Dim>(map.linear);
        return result;
    }
    const OnHull<Dim> hull(*basis);
    const Dyadic whole = hull.determinantOf(exactMatrix<Dim>(Matrix<Dim>::Identity()));
    Dyadic excess = -whole, terms;
    for (const auto& map : maps) {
        const ExactMatrix<Dim> linear = exactMatrix<Dim>(map.linear);
        excess = excess + hull.determinantOf(linear);
        terms = terms + hull.termsOf(linear);
    }
    result.value = roundedQuotient(excess, whole);
    result.rounding = 2 * Dim * StoredRounding<Dim>::share * roundedQuotient(terms, whole);
    return result;
}

template Dyadic excessOfDeterminants<2>(std::span<const AffineMap<2>>);
template Dyadic excessOfDeterminants<3>(std::span<const AffineMap<3>>);
template bool fillSpace<2>(std::span<const AffineMap<2>>);
template bool fillSpace<3>(std::span<const AffineMap<3>>);
template std::optional<HullExcess> excessOnHull<2>(std::span<const AffineMap<2>>);
template std::optional<HullExcess> excessOnHull<3>(std::span<const AffineMap<3>>);

} // namespace ifs
