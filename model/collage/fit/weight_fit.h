// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <Eigen/Core>

#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace collage {

// A measure on the pixels of a picture, rows from the top. Nothing is negative; the sum need not be 1. In the
// plane, the height of the picture is 1 unit, y is up and its middle is the origin.
struct Density {
    int width = 0;
    int height = 0;
    std::vector<double> mass;
};

// The weights with which the maps reproduce the measure best: p ≥ 0 with sum 1 that minimises
// ‖ν − Σ p_i (w_i)_#ν‖² after both have been blurred by a Gaussian with standard deviation `blur` pixels.
// docs/mathematics.md, "Collages". Equal weights when there is no mass.
// Empty when stopped.
std::vector<double> fittedWeights(const Density& density, std::span<const ifs::AffineMap<2>> maps,
                                  double blur = 2, const std::stop_token& stop = {});

// Upper bound of the Monge–Kantorovich distance of the invariant measure μ of the maps with these weights
// from the measure ν, in pixels: d(μ, ν) ≤ d(ν, Mν)/(1 − Σ p_i s_i), where Mν = Σ p_i (w_i)_#ν and s_i is the
// spectral norm of a map. The weights must have the sum 1. nullopt when the maps do not contract on average,
// when there is no mass, and when stopped.
std::optional<double> measureBound(const Density& density, std::span<const ifs::AffineMap<2>> maps,
                                   std::span<const double> weights, const std::stop_token& stop = {});

// The p ≥ 0 with sum 1 that minimises pᵀ Q p − 2 cᵀ p, for a symmetric positive semidefinite Q: a primal
// active-set method, exact up to rounding.
Eigen::VectorXd simplexMinimum(const Eigen::MatrixXd& q, const Eigen::VectorXd& c);

} // namespace collage
