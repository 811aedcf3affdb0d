// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/existence/dyadic.h"
#include "ifs/separation/exact_map.h"
#include "ifs/system/affine_map.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace ifs {

// The fixed point of the first map, and directions that span the affine hull of the attractor from there; in
// each its pivot, a coordinate that does not vanish there but does in all that follow.
template <int Dim> struct HullBasis {
    struct Direction {
        std::array<Dyadic, std::size_t(Dim)> way;
        std::size_t pivot;
    };
    std::vector<Direction> directions;
    ExactPoint<Dim> point;
};

// nullopt where there is no map. The maps must have an attractor.
template <int Dim> std::optional<HullBasis<Dim>> hullBasis(std::span<const AffineMap<Dim>> maps);

// The smallest affine subspace that contains the attractor, known without rounding.
struct AffineHull {
    int dimension = 0;
    // Axes along which it extends, if it is parallel to as many as its dimension.
    std::optional<std::vector<int>> axes{};
};

// The affine hull of the attractor, which the maps must have; nullopt where there is no map. Of linked maps
// it holds the attractor, and may be larger than its hull.
template <int Dim> std::optional<AffineHull> affineHull(std::span<const AffineMap<Dim>> maps);

} // namespace ifs
