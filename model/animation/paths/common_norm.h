// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <optional>
#include <span>

namespace animation {

// Coordinates y = root·x, root symmetric and positive definite, in which maps contract.
template <int Dim> struct CommonNorm {
    ifs::Matrix<Dim> root = ifs::Matrix<Dim>::Identity();
    ifs::Matrix<Dim> inverse = ifs::Matrix<Dim>::Identity();
    bool isEuclidean = true;
};

// A norm |root·x| in which every one of the maps contracts: the Euclidean one where that does, else √(xᵀPx)
// with P = I + Σ AᵀPA, or from an invariant form of the maps. nullopt where none of these serves.
// docs/mathematics.md, "Ellipsoidal norm".
template <int Dim> std::optional<CommonNorm<Dim>> commonNorm(std::span<const ifs::AffineMap<Dim>> maps);

} // namespace animation
