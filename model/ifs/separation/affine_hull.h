// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <optional>
#include <span>
#include <vector>

namespace ifs {

// The smallest affine subspace that contains the attractor, known without rounding.
struct AffineHull {
    int dimension = 0;
    // Axes along which it extends, if it is parallel to as many as its dimension.
    std::optional<std::vector<int>> axes{};
};

// The affine hull of the attractor, which the maps must have; nullopt where there is no map.
template <int Dim> std::optional<AffineHull> affineHull(std::span<const AffineMap<Dim>> maps);

} // namespace ifs
