// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace ifs {

// The D with Σ s_i^D = 1; 0 for a single ratio. Ratios must lie in (0, 1), else nullopt.
std::optional<double> moranDimension(std::span<const double> ratios);

// The ratios of the maps when every map is a similarity, in these or other coordinates, to 1e-9; nullopt
// otherwise.
template <int Dim> std::optional<std::vector<double>> similarityRatios(std::span<const AffineMap<Dim>> maps);

// Moran's D of these ratios: an upper bound of the dimension of the attractor, which it is under the open set
// condition.
template <int Dim> std::optional<double> similarityDimension(std::span<const AffineMap<Dim>> maps);

// Returns true if the dimension exceeds that of the space: then the open set condition fails.
constexpr bool exceedsSpace(double similarityDimension, int spaceDimension) {
    return similarityDimension > spaceDimension * (1 + 1e-6);
}

// A dimension as a set in that space can have it. isCapped: it is larger, by more than it may be off.
struct CappedDimension {
    double value = 0, error = 0;
    bool isCapped = false;
};
constexpr CappedDimension capped(double dimension, double error, int spaceDimension) {
    if (dimension - error > spaceDimension) return {double(spaceDimension), 0, true};
    return {dimension < spaceDimension ? dimension : double(spaceDimension), error, false};
}

// Error of a similarity dimension that is due to the ratios, which are known to 1e-9.
template <int Dim> double similarityDimensionError(std::span<const AffineMap<Dim>> maps, double dimension);

// φ^t(A), Falconer's singular value function, t ≥ 0.
template <int Dim> double singularValueFunction(const Matrix<Dim>& linear, double t);

// Falconer's affinity dimension (not capped at Dim), by the transfer operator on directions in the plane, and
// exactly where every map is flat; an upper bound of the box dimension. nullopt without an attractor, where
// the error is not reached, or when stopped.
std::optional<double> affinityDimension(std::span<const AffineMap<2>> maps, const std::stop_token& stop = {});
constexpr double affinityDimensionError = 1e-6; // error bound

} // namespace ifs
