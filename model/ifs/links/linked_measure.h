// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/dimension/moments.h"
#include "ifs/system/links.h"

#include <optional>

// Numbers of the invariant measure Σ π_j μ_j of linked maps, whose parts are μ_j = Σ_i Q_ji μ_i∘w_j⁻¹ with
// the backward chain Q, and of their attractor. docs/mathematics.md, "Linked maps".
namespace ifs {

inline constexpr std::size_t maxLinkedStates = 128; // limit; nothing here is computed for more

// Exact up to the bounds given; `longRunCovariance` is not a number. Asks that the maps have an attractor.
// nullopt where the linear systems are too large or too badly conditioned for a proof.
template <int Dim> std::optional<Moments<Dim>> linkedMoments(const ActiveMaps<Dim>& active);

// −Σ π_i T_ij ln T_ij, in nats for each map applied.
double entropyRate(const Transitions& chain);

// Σ π_i ln s_i where all maps are similarities, with the ratios s_i.
template <int Dim> std::optional<double> linkedLyapunovExponent(const ActiveMaps<Dim>& active);

// The s at which the matrix with the entries s_j^s, where map j may follow map i, has the spectral radius 1;
// of several closed parts the largest. An upper bound of the dimension of the attractor, which it is under
// the open set condition. nullopt unless all maps are contracting similarities.
template <int Dim> std::optional<double> linkedDimension(const ActiveMaps<Dim>& active);

// How far that dimension is off, at most, as far as the ratios are known to 1e-9; nullopt where no bound is
// found.
template <int Dim>
std::optional<double> linkedDimensionError(const ActiveMaps<Dim>& active, double dimension);

// An upper bound of the dimension of the measure: of each closed part its entropy divided by its exponent, of
// several parts the largest. nullopt unless all maps are contracting similarities.
template <int Dim> std::optional<double> linkedMeasureDimension(const ActiveMaps<Dim>& active);

} // namespace ifs
