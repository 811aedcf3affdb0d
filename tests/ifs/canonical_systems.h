// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/iterated_function_system.h"

#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

// Systems whose facts are known, and seeded random ones, for the tests of model/ifs.
namespace canonical {

using Maps2 = std::vector<ifs::AffineMap<2>>;
using Maps3 = std::vector<ifs::AffineMap<3>>;

inline Maps2 maple() {
    return {ifs::affineMap(-0.04, 0, -0.23, -0.65, -0.08, 0.26), ifs::affineMap(0.61, 0, 0, 0.31, 0.07, 3.5),
            ifs::affineMap(0.65, 0.29, -0.3, 0.48, 0.74, 0.39),
            ifs::affineMap(0.64, -0.3, 0.16, 0.56, -0.56, 0.60)};
}
inline Maps2 flower() {
    return {ifs::affineMap(0.47, 0.30, -0.30, 0.47, 0.37, 1.74),
            ifs::affineMap(0.48, -0.29, 0.29, 0.48, -0.34, 1.75)};
}
inline Maps2 fern() {
    return {ifs::affineMap(0, 0, 0, 0.16, 0, 0), ifs::affineMap(0.85, 0.04, -0.04, 0.85, 0, 1.6),
            ifs::affineMap(0.2, -0.26, 0.23, 0.22, 0, 1.6), ifs::affineMap(-0.15, 0.28, 0.26, 0.24, 0, 0.44)};
}
inline const std::vector<double> fernWeights{0.01, 0.85, 0.07, 0.07};
inline Maps2 halves(std::initializer_list<ifs::Vector<2>> translations) {
    Maps2 maps;
    for (const auto& t : translations)
        maps.push_back({0.5 * ifs::Matrix<2>::Identity(), t});
    return maps;
}
inline Maps2 sierpinskiRight() {
    return halves({{0, 0}, {.5, 0}, {0, .5}});
}
inline Maps2 sierpinskiEquilateral() {
    return halves({{0, 0}, {.5, 0}, {.25, std::sqrt(3) / 4}});
}
inline Maps2 square() {
    return halves({{0, 0}, {.5, 0}, {0, .5}, {.5, .5}});
}
inline ifs::AffineMap<2> similarity(double ratio, double angle, double e, double f) {
    const double c = ratio * std::cos(angle), s = ratio * std::sin(angle);
    return ifs::affineMap(c, -s, s, c, e, f);
}
inline Maps2 koch() {
    const double third = 1.0 / 3, sixty = std::numbers::pi / 3;
    return {similarity(third, 0, 0, 0), similarity(third, sixty, third, 0),
            similarity(third, -sixty, .5, std::sqrt(3) / 6), similarity(third, 0, 2 * third, 0)};
}
inline Maps2 levy() {
    return {ifs::affineMap(.5, -.5, .5, .5, 0, 0), ifs::affineMap(.5, .5, -.5, .5, .5, .5)};
}
inline Maps2 heighway() {
    return {ifs::affineMap(.5, -.5, .5, .5, 0, 0), ifs::affineMap(-.5, -.5, .5, -.5, 1, 0)};
}
inline Maps2 twin() {
    return {ifs::affineMap(.5, -.5, .5, .5, 0, 0), ifs::affineMap(.5, -.5, .5, .5, .5, -.5)};
}
// Not contractive in the Euclidean norm, yet every word of length 5 is.
inline Maps2 eventual() {
    return {ifs::affineMap(.5, 2, 0, .5, 0, 0), ifs::affineMap(.5, 0, .1, .3, 1, 0)};
}

inline ifs::AffineMap<3> map3(const ifs::Matrix<3>& linear, const ifs::Vector<3>& translation) {
    return {linear, translation};
}
inline Maps3 tetrahedron() {
    Maps3 maps{map3(ifs::Matrix<3>::Identity() / 2, {0, 0, 0})};
    for (int k = 0; k < 3; ++k)
        maps.push_back(map3(ifs::Matrix<3>::Identity() / 2, ifs::Vector<3>::Unit(k) / 2));
    return maps;
}
inline Maps3 cube() {
    Maps3 maps;
    for (int corner = 0; corner < 8; ++corner)
        maps.push_back(map3(ifs::Matrix<3>::Identity() / 2,
                            ifs::Vector<3>(corner & 1, corner >> 1 & 1, corner >> 2 & 1) / 2));
    return maps;
}
inline Maps3 fern3() {
    ifs::Matrix<3> stem = ifs::Matrix<3>::Zero(), frond, left, right;
    stem(1, 1) = .18;
    frond << .85, 0, 0, 0, .85, .1, 0, -.1, .85;
    left << .2, -.2, 0, .2, .2, 0, 0, 0, .3;
    right << -.2, .2, 0, .2, .2, 0, 0, 0, .3;
    return {map3(stem, {0, 0, 0}), map3(frond, {0, 1.6, 0}), map3(left, {0, .8, 0}), map3(right, {0, .8, 0})};
}

// In other units of length.
template <int Dim>
std::vector<ifs::AffineMap<Dim>> scaled(std::vector<ifs::AffineMap<Dim>> maps, double size) {
    for (auto& map : maps)
        map.translation *= size;
    return maps;
}

template <int Dim>
ifs::IteratedFunctionSystem<Dim> system(const std::vector<ifs::AffineMap<Dim>>& maps,
                                        const std::vector<double>& weights = {}) {
    ifs::IteratedFunctionSystem<Dim> result;
    for (std::size_t i = 0; i < maps.size(); ++i)
        append(result, maps[i], weights.empty() ? std::nullopt : std::optional(weights[i]));
    return result;
}

// w_σ of an address given outermost first, maps numbered from 1.
template <int Dim>
ifs::AffineMap<Dim> word(const std::vector<ifs::AffineMap<Dim>>& maps, std::initializer_list<int> address) {
    ifs::AffineMap<Dim> result;
    for (const int symbol : address)
        result = result * maps[std::size_t(symbol - 1)];
    return result;
}

using Random = std::mt19937_64;
inline double uniform(Random& random, double low = -1, double high = 1) {
    return low + (high - low) * double(random() >> 11) * 0x1p-53;
}
template <int Dim> ifs::Vector<Dim> randomVector(Random& random, double size = 1) {
    ifs::Vector<Dim> v;
    for (int k = 0; k < Dim; ++k)
        v[k] = uniform(random, -size, size);
    return v;
}
template <int Dim> ifs::Matrix<Dim> randomMatrix(Random& random, double size = 1) {
    ifs::Matrix<Dim> m;
    for (int k = 0; k < Dim; ++k)
        m.col(k) = randomVector<Dim>(random, size);
    return m;
}
template <int Dim> ifs::Matrix<Dim> randomWellConditioned(Random& random, double condition = 10) {
    for (;;) {
        const ifs::Matrix<Dim> m = randomMatrix<Dim>(random, 2);
        const ifs::Vector<Dim> stretch = ifs::singularValues<Dim>(m);
        if (stretch[0] <= condition * stretch[Dim - 1]) return m;
    }
}
// Maps of norm at most `norm`, some of them singular.
template <int Dim>
std::vector<ifs::AffineMap<Dim>> randomContractions(Random& random, int count, double norm = 0.8) {
    std::vector<ifs::AffineMap<Dim>> maps;
    for (int i = 0; i < count; ++i) {
        ifs::Matrix<Dim> linear = randomMatrix<Dim>(random);
        if (random() % 8 == 0) linear.col(0).setZero();
        linear *= uniform(random, 0.1, norm) / ifs::spectralNorm<Dim>(linear);
        maps.push_back({linear, randomVector<Dim>(random, 3)});
    }
    return maps;
}
// `count` points of the attractor: a chaos game that starts in a fixed point.
template <int Dim>
std::vector<ifs::Vector<Dim>> orbit(const std::vector<ifs::AffineMap<Dim>>& maps, int count, Random& random) {
    std::vector<ifs::Vector<Dim>> points{*ifs::fixedPoint(maps[0])};
    while (int(points.size()) < count)
        points.push_back(maps[random() % maps.size()](points.back()));
    return points;
}

inline constexpr double quietNaN = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

} // namespace canonical
