// SPDX-License-Identifier: MIT
#include "ifs/separation/surd_map.h"

#include <algorithm>

namespace ifs {

namespace {

// The determinant of the matrix without a row and a column.
Surd minorOf(const std::vector<std::vector<Surd>>& m, std::size_t row, std::size_t column);

Surd determinantOf(const std::vector<std::vector<Surd>>& m) {
    if (m.empty()) return {1};
    Surd result;
    for (std::size_t j = 0; j < m.size(); ++j) {
        const Surd term = m[0][j] * minorOf(m, 0, j);
        result = j % 2 == 0 ? result + term : result - term;
    }
    return result;
}

Surd minorOf(const std::vector<std::vector<Surd>>& m, std::size_t row, std::size_t column) {
    std::vector<std::vector<Surd>> rest;
    for (std::size_t i = 0; i < m.size(); ++i) {
        if (i == row) continue;
        rest.emplace_back();
        for (std::size_t j = 0; j < m.size(); ++j)
            if (j != column) rest.back().push_back(m[i][j]);
    }
    return determinantOf(rest);
}

std::vector<Surd> product(const std::vector<std::vector<Surd>>& m, const std::vector<Surd>& x) {
    std::vector<Surd> result(x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
        for (std::size_t j = 0; j < x.size(); ++j)
            result[i] = result[i] + m[i][j] * x[j];
    return result;
}

template <int Dim> SurdMap typedMap(const WeightedMap<Dim>& map) {
    constexpr int numbers = Dim * (Dim + 1);
    std::vector<Surd> values;
    for (int which = 0; which < numbers; ++which) {
        const TypedCoefficient* typed = map.typed.of(which, map.map);
        values.push_back(typed ? typed->value : Surd::stored(coefficient(map.map, which)));
    }
    SurdMap result;
    for (int i = 0; i < Dim; ++i)
        result.linear.emplace_back(values.begin() + i * Dim, values.begin() + (i + 1) * Dim);
    result.translation.assign(values.begin() + Dim * Dim, values.end());
    return result;
}

// Returns true if a typed number differs from the double next to it.
template <int Dim> bool isAnyTyped(const WeightedMap<Dim>& map) {
    if (map.typed.isEmpty()) return false;
    for (int which = 0; which < Dim * (Dim + 1); ++which)
        if (const TypedCoefficient* typed = map.typed.of(which, map.map);
            typed && !(typed->value == Surd::stored(typed->number)))
            return true;
    return false;
}

} // namespace

bool SurdMap::hasValue() const {
    const auto haveValues = [](const std::vector<Surd>& numbers) {
        return std::ranges::all_of(numbers, &Surd::hasValue);
    };
    return haveValues(translation) && std::ranges::all_of(linear, haveValues);
}

SurdMap identity(std::size_t dimension) {
    SurdMap result{std::vector(dimension, std::vector<Surd>(dimension)), std::vector<Surd>(dimension)};
    for (std::size_t i = 0; i < dimension; ++i)
        result.linear[i][i] = Surd(1);
    return result;
}

SurdMap operator*(const SurdMap& outer, const SurdMap& inner) {
    const std::size_t size = outer.dimension();
    SurdMap result{std::vector(size, std::vector<Surd>(size)), product(outer.linear, inner.translation)};
    for (std::size_t i = 0; i < size; ++i) {
        result.translation[i] = result.translation[i] + outer.translation[i];
        for (std::size_t j = 0; j < size; ++j)
            for (std::size_t k = 0; k < size; ++k)
                result.linear[i][j] = result.linear[i][j] + outer.linear[i][k] * inner.linear[k][j];
    }
    return result;
}

// The inverse by Cramer's rule.
SurdMap inverse(const SurdMap& map) {
    const std::size_t size = map.dimension();
    const Surd determinant = determinantOf(map.linear);
    SurdMap result{std::vector(size, std::vector<Surd>(size)), {}};
    for (std::size_t i = 0; i < size; ++i)
        for (std::size_t j = 0; j < size; ++j) {
            const Surd minor = minorOf(map.linear, j, i);
            result.linear[i][j] = ((i + j) % 2 == 0 ? minor : -minor) / determinant;
        }
    for (const Surd& number : product(result.linear, map.translation))
        result.translation.push_back(-number);
    return result;
}

std::optional<Surd> squaredRatio(const SurdMap& map) {
    std::optional<Surd> ratio;
    for (std::size_t i = 0; i < map.dimension(); ++i)
        for (std::size_t j = i; j < map.dimension(); ++j) {
            Surd sum;
            for (std::size_t k = 0; k < map.dimension(); ++k)
                sum = sum + map.linear[k][i] * map.linear[k][j];
            if (i != j ? !sum.isZero() : !sum.hasValue() || (ratio && !(*ratio == sum))) return std::nullopt;
            if (i == j) ratio = sum;
        }
    return ratio;
}

Surd determinant(const SurdMap& map) {
    return determinantOf(map.linear);
}

SurdMap word(std::span<const SurdMap> maps, const Word& word) {
    SurdMap result = identity(maps.front().dimension());
    for (const int symbol : word)
        result = result * maps[std::size_t(symbol)];
    return result;
}

std::optional<SurdMap> restricted(const SurdMap& map, std::span<const int> axes) {
    const auto isAlong = [&](std::size_t axis) { return std::ranges::find(axes, int(axis)) != axes.end(); };
    for (std::size_t i = 0; i < map.dimension(); ++i) {
        if (!isAlong(i) && !map.translation[i].isZero()) return std::nullopt;
        for (std::size_t j = 0; j < map.dimension(); ++j)
            if (isAlong(i) != isAlong(j) && !map.linear[i][j].isZero()) return std::nullopt;
    }
    SurdMap result;
    for (const int row : axes) {
        result.linear.emplace_back();
        for (const int column : axes)
            result.linear.back().push_back(map.linear[std::size_t(row)][std::size_t(column)]);
        result.translation.push_back(map.translation[std::size_t(row)]);
    }
    return result;
}

template <int Dim>
std::vector<SurdMap> typedMaps(const IteratedFunctionSystem<Dim>& system, const ActiveMaps<Dim>& active) {
    if (!std::ranges::any_of(system.maps, isAnyTyped<Dim>) || system.symmetry.group != SymmetryGroup::None)
        return {};
    std::vector<SurdMap> result;
    for (const std::size_t index : active.index) {
        result.push_back(typedMap<Dim>(system.maps[index]));
        if (!result.back().hasValue()) return {};
    }
    return result;
}

template std::vector<SurdMap> typedMaps(const IteratedFunctionSystem<2>&, const ActiveMaps<2>&);
template std::vector<SurdMap> typedMaps(const IteratedFunctionSystem<3>&, const ActiveMaps<3>&);

} // namespace ifs
