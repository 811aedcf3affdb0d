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
    // Those along which it extends, if it is parallel to as many axes as its dimension.
    std::optional<std::vector<int>> axes{};
};

// Of maps that have an attractor; nullopt where there is no map.
template <int Dim> std::optional<AffineHull> affineHull(std::span<const AffineMap<Dim>> maps);

} // namespace ifs
