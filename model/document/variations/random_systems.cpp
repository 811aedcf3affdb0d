// SPDX-License-Identifier: MIT
#include "document/variations/random_systems.h"

#include "document/variations/chance.h"
#include "document/variations/filling.h"

#include <utility>
#include <vector>

namespace document {

namespace {

constexpr int trials = 60;
constexpr double maxSingularValue = 0.95;
constexpr double minRatio = 0.12; // initial ratio to the largest map
constexpr double upright = 90;    // degrees; direction of a mirror

using Pair = ifs::Vector<2>; // σ₁ ≥ σ₂

// Pairs of singular values with Σ(σ₁ + 2σ₂) = total: drawn evenly, and then all raised to the same power, so
// that no map is favoured and none stretches.
std::vector<Pair> singularPairs(std::size_t count, double total, Chance& chance) {
    std::vector<Pair> drawn;
    for (std::size_t i = 0; i < count; ++i) {
        const double first = chance.between(minRatio, 1);
        drawn.emplace_back(first, first * chance.between(minRatio, 1));
    }
    const auto raised = [](const Pair& pair, double power) {
        return Pair(maxSingularValue * std::pow(pair[0], power), maxSingularValue * std::pow(pair[1], power));
    };
    double low = 0, high = 64;
    for (int step = 0; step < 60; ++step) {
        const double power = (low + high) / 2;
        double sum = 0;
        for (const Pair& pair : drawn)
            sum += raised(pair, power).dot(Pair(1, 2));
        (sum > total ? low : high) = power;
    }
    for (Pair& pair : drawn)
        pair = raised(pair, high);
    return drawn;
}

// A random linear map with these singular values; in two of five cases one that hardly turns, as in plants.
template <int Dim> ifs::Matrix<Dim> linearMap(const ifs::Vector<Dim>& singularValues, Chance& chance) {
    const bool hardlyTurns = chance.comes(0.4);
    const ifs::Matrix<Dim> inner =
        hardlyTurns ? chance.rotation<Dim>(chance.between(-0.6, 0.6)) : chance.anyRotation<Dim>();
    ifs::Matrix<Dim> outer;
    if (hardlyTurns)
        outer = chance.rotation<Dim>(chance.between(-0.5, 0.5)) * inner.transpose();
    else
        outer = chance.anyRotation<Dim>();
    ifs::Vector<Dim> stretch = singularValues;
    if (chance.comes(0.2)) stretch[Dim - 1] = -stretch[Dim - 1];
    return outer * stretch.asDiagonal() * inner;
}

template <int Dim> ifs::Symmetry<Dim> symmetryOf(const RandomChoice& choice) {
    using enum ifs::SymmetryGroup;
    ifs::Symmetry<Dim> symmetry;
    symmetry.group = choice.symmetry;
    symmetry.order = choice.order;
    if (choice.symmetry == Mirror || choice.symmetry == Dihedral) symmetry.angle = upright;
    return symmetry;
}

template <int Dim> ifs::IteratedFunctionSystem<Dim> randomSystem(const RandomChoice& choice, Chance& chance) {
    ifs::IteratedFunctionSystem<Dim> system;
    system.symmetry = symmetryOf<Dim>(choice);
    const bool isSymmetric = choice.symmetry != ifs::SymmetryGroup::None;
    const std::size_t copies = ifs::groupOrder(choice.symmetry, choice.order);
    std::size_t count = std::size_t(choice.maps);
    if (count == 0) count = isSymmetric ? 1 + chance.below(3) : 2 + chance.below(4);
    if (!isSymmetric && count == 1) count = 2; // the attractor of a single map is a point
    const double all = double(count * copies);
    const double total = (5 + all + chance.between(0.01, 0.99)) / 2;
    for (const Pair& pair : singularPairs(count, total / double(copies), chance)) {
        ifs::Vector<Dim> values;
        values.template head<2>() = pair;
        if constexpr (Dim == 3) values[2] = pair[1] * chance.between(0.3, 1);
        const ifs::Matrix<Dim> linear = linearMap<Dim>(values, chance);
        ifs::append(system, {linear, chance.vector<Dim>()});
    }
    const std::vector<double> weights = ifs::determinantWeights<Dim>(ifs::mapsOf(system), 0.02);
    for (std::size_t i = 0; i < weights.size(); ++i)
        system.maps[i].weight = weights[i];
    return system;
}

} // namespace

Fractal randomFractal(const RandomChoice& choice, std::uint64_t seed) {
    Chance chance(seed);
    Fractal fractal, best;
    fractal.name = QStringLiteral("random%1").arg(seed % 1'000'000);
    double most = -1;
    for (int trial = 0; trial < trials && most < 1; ++trial) {
        fractal.supports = SupportCache();
        if (choice.dimension == 3)
            fractal.shape = Shape<3>{randomSystem<3>(choice, chance)};
        else
            fractal.shape = Shape<2>{randomSystem<2>(choice, chance)};
        const double filled = hasCertainAttractor(fractal) ? fillsAs(filling(fractal), wellFilled) : -1;
        if (filled <= most) continue;
        most = filled;
        best = fractal;
    }
    return best;
}

} // namespace document
