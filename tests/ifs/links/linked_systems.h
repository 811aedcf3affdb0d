// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/links.h"

#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <tuple>
#include <vector>

// Systems of linked maps of which much is known.
namespace linked_systems {

using System = ifs::IteratedFunctionSystem<2>;
using Complex = std::complex<double>;

inline ifs::AffineMap<2> similarity(Complex factor, Complex shift) {
    return ifs::affineMap(factor.real(), -factor.imag(), factor.imag(), factor.real(), shift.real(),
                          shift.imag());
}

// Equal weights; the matrix by rows.
inline System system(const std::vector<ifs::AffineMap<2>>& maps, const std::vector<double>& matrix) {
    System result;
    for (const auto& map : maps)
        ifs::append(result, map, 1.0);
    ifs::setLinks(result, matrix);
    return result;
}

// x/3, x/3 + 1/3, x/3 + 2/3 on a line: only 1→2, 2→3, 3→1 and 3→3. The other way round, everything differs.
inline System threeOnALine() {
    std::vector<ifs::AffineMap<2>> maps;
    for (const double shift : {0.0, 1 / 3.0, 2 / 3.0})
        maps.push_back(ifs::affineMap(1 / 3.0, 0, 0, 1 / 3.0, shift, 0));
    return system(maps, {0, 1, 0, 0, 0, 1, 1, 0, 1});
}

// Doubling maps without two ones in a row.
inline System goldenMean() {
    return system({ifs::affineMap(.5, 0, 0, .5, 0, 0), ifs::affineMap(.5, 0, 0, .5, .5, 0)}, {1, 1, 1, 0});
}

constexpr double tribonacci = 1.839286755214161;

// The contracting root of λ³ = λ² + λ + 1, with λ³ − λ² − λ − 1 = (λ − t)(λ² + (t − 1)λ + 1/t).
inline Complex rauzyFactor() {
    const double half = (1 - tribonacci) / 2;
    return {half, std::sqrt(1 / tribonacci - half * half)};
}

// The tile of the substitution 1 → 12, 2 → 13, 3 → 1: R₁ = β(R₁ ∪ R₂ ∪ R₃), R₂ = βR₁ + 1, R₃ = βR₂ + 1.
inline System rauzy() {
    const Complex beta = rauzyFactor();
    return system({similarity(beta, 0), similarity(beta, 1), similarity(beta, 1)},
                  {1, 1, 0, 1, 0, 1, 1, 0, 0});
}

// The boundary of Heighway's dragon T = f₀(T) ∪ f₁(T) by its graph of neighbours: where T meets its neighbour
// h(T), it is the union of f_i(T ∩ h′(T)) over i and j with h′ = f_i⁻¹ h f_j. One map for each (h, i, h′);
// the images of T ∩ h′(T) that it may follow are those with this h′.
inline System dragonBoundary() {
    using Map = std::pair<Complex, Complex>; // z ↦ first·z + second
    const std::vector<Map> f{{{.5, .5}, 0}, {{-.5, .5}, 1}};
    const auto after = [](const Map& p, const Map& q) {
        return Map{p.first * q.first, p.first * q.second + p.second};
    };
    const auto inverse = [](const Map& p) { return Map{1.0 / p.first, -p.second / p.first}; };
    const auto key = [](const Map& p) {
        const auto rounded = [](double x) { return std::lround(x * 4096); };
        return std::tuple(rounded(p.first.real()), rounded(p.first.imag()), rounded(p.second.real()),
                          rounded(p.second.imag()));
    };
    const Complex centre(.5, .25);
    const double reach = std::sqrt(5.0) / 4 / (1 - std::numbers::sqrt2 / 2);
    const auto mayMeet = [&](const Map& h) {
        return std::abs(h.first * centre + h.second - centre) <= 2 * reach;
    };
    using Key = decltype(key(f[0]));
    struct Edge {
        Key from;
        std::size_t i;
        Key to;
    };
    std::map<Key, Map> known;
    std::vector<Map> open{after(inverse(f[0]), f[1]), after(inverse(f[1]), f[0])};
    std::vector<Edge> edges;
    for (const Map& h : open)
        known.emplace(key(h), h);
    while (!open.empty()) {
        const Map h = open.back();
        open.pop_back();
        for (std::size_t i = 0; i < 2; ++i)
            for (const Map& other : f) {
                const Map next = after(inverse(f[i]), after(h, other));
                if (!mayMeet(next)) continue;
                edges.push_back({key(h), i, key(next)});
                if (known.emplace(key(next), next).second) open.push_back(next);
            }
    }
    System result;
    for (const Edge& edge : edges)
        ifs::append(result, similarity(f[edge.i].first, f[edge.i].second), 1.0);
    std::vector<double> matrix;
    for (const Edge& before : edges)
        for (const Edge& edge : edges)
            matrix.push_back(before.from == edge.to ? 1 : 0);
    ifs::setLinks(result, matrix);
    return result;
}

} // namespace linked_systems
