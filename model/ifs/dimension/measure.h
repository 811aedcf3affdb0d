// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/iterated_function_system.h"

#include <optional>
#include <span>

// Numbers of the measure that the probabilities make. docs/mathematics.md, "Dimensions".
namespace ifs {

// −Σ p_i ln p_i in nats, of probabilities that sum to 1.
double entropy(std::span<const double> probabilities);

// Σ p_i ln s_i, by which the logarithm of a length changes with every map on average; where all maps are
// similarities, with the ratios s_i, in some coordinates. nullopt otherwise.
template <int Dim> std::optional<double> lyapunovExponent(const ActiveMaps<Dim>& maps);

// Entropy divided by −Lyapunov exponent: an upper bound of the dimension of the measure, which it is under
// the open set condition. It may be larger than that of space. nullopt without Lyapunov exponent.
template <int Dim> std::optional<double> measureDimension(const ActiveMaps<Dim>& maps);

// Some of Rényi's dimensions of the measure. Under the open set condition they are those where
// Σ pᵢ^q rᵢ^(−τ) = 1, D_q = τ/(1 − q) (Cawley and Mauldin).
struct DimensionSpectrum {
    double capacity = 0;    // D₀ of the attractor
    double information = 0; // D₁ of the measure
    double correlation = 0; // D₂
    double least = 0;       // D_∞ at the densest points
};

// The spectrum of similarities that are not all constant, in some coordinates.
template <int Dim> std::optional<DimensionSpectrum> dimensionSpectrum(const ActiveMaps<Dim>& maps);

} // namespace ifs
