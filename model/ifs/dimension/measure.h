// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/iterated_function_system.h"

#include <optional>
#include <span>

// Of the measure that the probabilities make. docs/mathematics.md, "Dimensions".
namespace ifs {

// −Σ p_i ln p_i in nats, of probabilities that sum to 1.
double entropy(std::span<const double> probabilities);

// Σ p_i ln s_i, by which the logarithm of a length changes with every map on average; where all maps are
// similarities, with the ratios s_i, in some coordinates. nullopt otherwise.
template <int Dim> std::optional<double> lyapunovExponent(const ActiveMaps<Dim>& maps);

// Entropy divided by −Lyapunov exponent, at most Dim: an upper bound of the dimension of the measure, which
// it is under the open set condition. nullopt without Lyapunov exponent.
template <int Dim> std::optional<double> measureDimension(const ActiveMaps<Dim>& maps);

} // namespace ifs
