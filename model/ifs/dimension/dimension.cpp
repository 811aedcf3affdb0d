// SPDX-License-Identifier: MIT
#include "ifs/dimension/dimension.h"

#include "ifs/dimension/common_eigendirections.h"
#include "ifs/dimension/rank_one.h"
#include "ifs/dimension/transfer_operator.h"
#include "ifs/existence/attractor_existence.h"
#include "ifs/existence/invariant_form.h"
#include "ifs/linear/rounding.h"
#include "ifs/system/iterated_function_system.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ifs {

namespace {

// The zero of a decreasing function on [low, high].
template <class Function> double bisect(Function function, double low, double high, int steps) {
    for (int n = 0; n < steps; ++n) {
        const double middle = (low + high) / 2;
        (function(middle) > 0 ? low : high) = middle;
    }
    return (low + high) / 2;
}

template <int Dim> std::vector<double> determinantRatios(std::span<const AffineMap<Dim>> maps) {
    std::vector<double> ratios;
    for (const auto& map : maps)
        if (const double det = std::abs(determinant<Dim>(map.linear)); det > 0)
            ratios.push_back(std::pow(det, 1.0 / Dim));
    return ratios;
}

// The solution t of Σ φ^t(A_i) = 1: an upper bound of the affinity dimension, in any dimension of space.
template <int Dim> double firstBound(std::span<const AffineMap<Dim>> maps) {
    constexpr double maxBound = 64;
    const auto excess = [maps](double t) {
        double sum = -1;
        for (const auto& map : maps)
            sum += singularValueFunction<Dim>(map.linear, t);
        return sum;
    };
    return bisect(excess, 0, maxBound, 60);
}

// Returns true if rounding leaves so little of the determinant that nothing is known of the eigenvalues.
bool isLostToRounding(const AffineMap<2>& map) {
    constexpr double telling = 1e-10;
    const Matrix<2>& m = map.linear;
    return !(roundingUnit * (std::abs(m(0, 0) * m(1, 1)) + std::abs(m(0, 1) * m(1, 0))) <= telling);
}

bool hasAttractor(std::span<const AffineMap<2>> maps) {
    return classify(maps).exists();
}

template <int Dim> std::optional<double> dimensionOf(std::span<const AffineMap<Dim>> maps) {
    if constexpr (Dim == 2) {
        if (const auto dimension = affinityDimension(maps)) return dimension;
        if (!hasAttractor(maps)) return std::nullopt;
    }
    if (const auto dimension = similarityDimension<Dim>(maps)) return dimension;
    return maps.empty() ? std::nullopt : std::optional(firstBound<Dim>(maps));
}

} // namespace

namespace {

// A solver for very many ratios. Σ sᵈ falls and is convex, so that Newton's steps from 0 come to the solution
// from below.
double newtonDimension(std::span<const double> ratios) {
    std::vector<double> logarithms;
    for (const double ratio : ratios)
        logarithms.push_back(std::log(ratio));
    double dimension = 0;
    constexpr int maxSteps = 100;
    for (int k = 0; k < maxSteps; ++k) {
        double excess = -1, slope = 0;
        for (const double logarithm : logarithms) {
            const double term = std::exp(dimension * logarithm);
            excess += term;
            slope += logarithm * term;
        }
        const double next = dimension - excess / slope;
        if (!(next > dimension)) break;
        dimension = next;
    }
    return dimension;
}

} // namespace

std::optional<double> moranDimension(std::span<const double> ratios) {
    if (ratios.empty() || !std::ranges::all_of(ratios, [](double s) { return s > 0 && s < 1; }))
        return std::nullopt;
    if (ratios.size() == 1) return 0;
    constexpr std::size_t many = 1'000;
    if (ratios.size() > many) return newtonDimension(ratios);
    const auto excess = [ratios](double dimension) {
        double sum = -1;
        for (const double ratio : ratios)
            sum += std::pow(ratio, dimension);
        return sum;
    };
    double high = 64;
    while (excess(high) > 0)
        high *= 2;
    constexpr int steps = 100;
    return bisect(excess, 0, high, steps);
}

template <int Dim> std::optional<std::vector<double>> similarityRatios(std::span<const AffineMap<Dim>> maps) {
    if (maps.empty() || !std::ranges::all_of(maps, isFinite<Dim>)) return std::nullopt;
    const auto form = invariantForm<Dim>(maps);
    std::vector<double> ratios = determinantRatios<Dim>(maps);
    if (!form || ratios.size() != maps.size() || !(singularValues<Dim>(*form)[Dim - 1] > 1e-12))
        return std::nullopt;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const Matrix<Dim> image =
            maps[i].linear.transpose() * *form * maps[i].linear / (ratios[i] * ratios[i]);
        if (!((image - *form).cwiseAbs().maxCoeff() <= 1e-9)) return std::nullopt;
    }
    return ratios;
}

template <int Dim> std::optional<double> similarityDimension(std::span<const AffineMap<Dim>> maps) {
    const auto ratios = similarityRatios<Dim>(maps);
    return ratios ? moranDimension(*ratios) : std::nullopt;
}

template <int Dim> double similarityDimensionError(std::span<const AffineMap<Dim>> maps, double dimension) {
    if (dimension == 0) return 0;
    double least = std::numeric_limits<double>::infinity(); // minimum of −ln s
    for (const double ratio : determinantRatios<Dim>(maps))
        least = std::min(least, -std::log(ratio));
    return 1e-9 * dimension / least;
}

template <int Dim> double singularValueFunction(const Matrix<Dim>& linear, double t) {
    if (t >= Dim) return std::pow(std::abs(determinant<Dim>(linear)), t / Dim);
    const Vector<Dim> sigma = singularValues<Dim>(linear);
    double result = 1;
    for (int k = 0; k < Dim && t > 0; ++k, t -= 1)
        result *= t >= 1 ? sigma[k] : std::pow(sigma[k], t);
    return result;
}

std::optional<double> affinityDimension(std::span<const AffineMap<2>> maps, const std::stop_token& stop) {
    if (!hasAttractor(maps)) return std::nullopt;
    if (maps.size() == 1) return 0;
    if (std::ranges::any_of(maps, isLostToRounding)) return std::nullopt;
    if (const auto dimension = similarityDimension(maps)) return dimension;
    double area = 0;
    for (const auto& map : maps)
        area += std::abs(determinant<2>(map.linear));
    if (area >= 1) // the pressure above 2 is ln Σ |det A_i|^(t/2)
        return moranDimension(determinantRatios<2>(maps));
    if (const auto dimension = commonEigendirectionsDimension(maps)) return dimension;
    if (std::ranges::all_of(maps, [](const auto& map) { return isFlat(map.linear); }))
        return rankOneDimension(maps, stop);
    return transferDimension(maps, stop);
}

template <int Dim> std::vector<double> dimensionWeights(std::span<const AffineMap<Dim>> maps, double floor) {
    const auto dimension = dimensionOf<Dim>(maps);
    if (!dimension) return determinantWeights(maps, floor);
    std::vector<double> masses;
    for (const auto& map : maps)
        masses.push_back(singularValueFunction<Dim>(map.linear, std::min<double>(*dimension, Dim)));
    return shares(std::move(masses), floor);
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template std::optional<std::vector<double>> similarityRatios<Dim>(std::span<const AffineMap<Dim>>);      \
    template std::optional<double> similarityDimension<Dim>(std::span<const AffineMap<Dim>>);                \
    template double similarityDimensionError<Dim>(std::span<const AffineMap<Dim>>, double);                  \
    template double singularValueFunction<Dim>(const Matrix<Dim>&, double);                                  \
    template std::vector<double> dimensionWeights<Dim>(std::span<const AffineMap<Dim>>, double);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace ifs
