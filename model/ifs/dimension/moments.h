// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/iterated_function_system.h"

#include <optional>

namespace ifs {

template <int Dim> struct Mean {
    Vector<Dim> point;
    double error = 0; // bound of the distance to the exact point
};

// Moments of the invariant measure μ = Σ p_i μ∘w_i⁻¹ (no sampling): solutions of small linear systems, with
// proved bounds of what rounding has cost. docs/mathematics.md, "Invariant measure".
template <int Dim> struct Moments {
    Vector<Dim> mean;
    Matrix<Dim> covariance;
    // N·Cov(mean of N successive chaos-game points) → Γ as N grows.
    Matrix<Dim> longRunCovariance;
    double meanError = 0;       // bound of the distance to the exact mean
    double covarianceError = 0; // error of each entry
};

// The limit of the expectation of the n-th chaos-game point, from any start; the mean of μ where μ has one.
// It is the fixed point of Σ p_i w_i and needs less than the covariance. nullopt when no map is active, or
// ρ(Σ p_i A_i) < 1 is not proved.
template <int Dim> std::optional<Mean<Dim>> mean(const ActiveMaps<Dim>& maps);

// The fixed point of any map for which I − A is proved to be regular.
template <int Dim> std::optional<Mean<Dim>> enclosedFixedPoint(const AffineMap<Dim>& map);

// nullopt when no map is active, or ρ(Σ p_i A_i⊗A_i) < 1, without which the covariance does not exist, is not
// proved.
template <int Dim> std::optional<Moments<Dim>> moments(const ActiveMaps<Dim>& maps);

} // namespace ifs
