// SPDX-License-Identifier: MIT
#include "ifs/separation/affine_hull.h"

#include "ifs/existence/dyadic.h"
#include "ifs/existence/exact_matrix.h"
#include "ifs/separation/exact_map.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace ifs {

namespace {

template <int Dim> using Direction = std::array<Dyadic, std::size_t(Dim)>;

// Independent directions, in echelon form.
template <int Dim> class Directions {
public:
    // Adds the direction; false if it is already in the span.
    bool add(Direction<Dim> direction) {
        for (const auto& [known, pivot] : m_known) {
            const Dyadic factor = direction[pivot];
            if (factor.sign() == 0) continue;
            for (std::size_t k = 0; k < Dim; ++k)
                direction[k] = direction[k] * known[pivot] - known[k] * factor;
        }
        for (std::size_t k = 0; k < Dim; ++k) {
            if (direction[k].sign() == 0) continue;
            m_known.emplace_back(std::move(direction), k);
            return true;
        }
        return false;
    }

    int size() const { return int(m_known.size()); }

    std::vector<typename HullBasis<Dim>::Direction> all() const {
        std::vector<typename HullBasis<Dim>::Direction> result;
        for (const auto& [way, pivot] : m_known)
            result.push_back({way, pivot});
        return result;
    }

private:
    std::vector<std::pair<Direction<Dim>, std::size_t>> m_known;
};

template <int Dim> std::optional<std::vector<int>> axesOf(const HullBasis<Dim>& basis) {
    std::vector<int> result;
    for (std::size_t axis = 0; axis < Dim; ++axis)
        if (std::ranges::any_of(basis.directions, [axis](const auto& d) { return d.way[axis].sign() != 0; }))
            result.push_back(int(axis));
    return result.size() == basis.directions.size() ? std::optional(result) : std::nullopt;
}

} // namespace

// Spanned by the differences of fixed points and by what the linear parts make of them.
template <int Dim> std::optional<HullBasis<Dim>> hullBasis(std::span<const AffineMap<Dim>> maps) {
    if (maps.empty()) return std::nullopt;
    Directions<Dim> directions;
    std::vector<Direction<Dim>> found;
    const auto add = [&](const Direction<Dim>& direction) {
        if (directions.add(direction)) found.push_back(direction);
    };
    std::vector<ExactMap<Dim>> exact;
    for (std::size_t i = 0; i < maps.size(); ++i)
        exact.push_back(exactWord<Dim>(maps, {int(i)}));
    const auto first = exactFixedPoint(exact.front());
    if (first.denominator.sign() == 0) return std::nullopt;
    for (const auto& map : exact) { // w(x) − x at the fixed point of the first map
        const auto moved = image(map, first);
        Direction<Dim> way;
        for (std::size_t k = 0; k < Dim; ++k)
            way[k] = moved.numerator[k] - first.numerator[k];
        add(way);
        if (directions.size() == Dim) return HullBasis<Dim>{directions.all(), first};
    }
    for (std::size_t k = 0; k < found.size() && directions.size() < Dim; ++k)
        for (const auto& map : exact) {
            Direction<Dim> turned;
            for (std::size_t i = 0; i < Dim; ++i)
                for (std::size_t j = 0; j < Dim; ++j)
                    turned[i] = turned[i] + map.linear[i][j] * found[k][j];
            add(turned);
        }
    return HullBasis<Dim>{directions.all(), first};
}

template <int Dim> std::optional<AffineHull> affineHull(std::span<const AffineMap<Dim>> maps) {
    const auto basis = hullBasis<Dim>(maps);
    if (!basis) return std::nullopt;
    return AffineHull{int(basis->directions.size()), axesOf<Dim>(*basis)};
}

template std::optional<HullBasis<2>> hullBasis<2>(std::span<const AffineMap<2>>);
template std::optional<HullBasis<3>> hullBasis<3>(std::span<const AffineMap<3>>);
template std::optional<AffineHull> affineHull<2>(std::span<const AffineMap<2>>);
template std::optional<AffineHull> affineHull<3>(std::span<const AffineMap<3>>);

} // namespace ifs
