// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/iterated_function_system.h"

#include <optional>

namespace ifs {

// Exact moments of the invariant measure μ = Σ p_i μ∘w_i⁻¹ (no sampling): solutions of small linear systems.
template <int Dim> struct Moments {
    Vector<Dim> mean;
    Matrix<Dim> covariance;
    // N·Cov(mean of N successive chaos-game points) → Γ as N grows.
    Matrix<Dim> longRunCovariance;
};

// What the expectation of the n-th chaos-game point tends to from any start, and the mean of μ where μ has
// one: the fixed point of Σ p_i w_i. It needs less than the covariance. nullopt when no map is active, or
// ρ(Σ p_i A_i) ≥ 1.
template <int Dim> std::optional<Vector<Dim>> mean(const ActiveMaps<Dim>& maps);

// nullopt when no map is active, or ρ(Σ p_i A_i⊗A_i) ≥ 1 and the covariance does not exist.
template <int Dim> std::optional<Moments<Dim>> moments(const ActiveMaps<Dim>& maps);

} // namespace ifs
