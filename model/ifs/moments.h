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

// nullopt when no map is active, or ρ(Σ p_i A_i⊗A_i) ≥ 1 and the covariance does not exist.
template <int Dim> std::optional<Moments<Dim>> moments(const ActiveMaps<Dim>& maps);

} // namespace ifs
