// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <optional>
#include <span>
#include <vector>

namespace ifs {

// A norm whose unit ball is a polytope that every map takes into `contractivity` times itself.
template <int Dim> struct PolytopeNorm {
    double contractivity = 0; // < 1, rounding included
    double equivalence = 1;   // C with |x| ≤ ‖x‖ ≤ C|x| after scaling
    int slowest = 0;          // index of the map that contracts least
    // Half of the ball's vertices, before scaling; the others are their opposites.
    std::vector<Vector<Dim>> vertices;
};

// The hull of a cross-polytope's images, images of images and so on under the maps divided by
// `contractivity`, when these end inside: they do for any number above the joint spectral radius, given the
// time. The linear parts may be off by `rounding` in norm. nullopt when the work runs out first.
// docs/mathematics.md, "Polytope norm".
// `maxWork`: products of two vectors, a nanosecond or two each.
template <int Dim>
std::optional<PolytopeNorm<Dim>> polytopeNorm(std::span<const AffineMap<Dim>> maps, double contractivity,
                                              double rounding = 0, std::size_t maxWork = 4'000'000);

} // namespace ifs
