// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <optional>
#include <span>
#include <vector>

namespace ifs {

// The maps B_i in coordinates y, x = image(y), where the longest ‖B_i‖ is as small as an ellipsoidal norm
// makes it. Maps whose products stretch a great deal before they contract hardly do so there.
// docs/mathematics.md, "Conditioning".
template <int Dim> struct Conditioned {
    AffineMap<Dim> image; // exact map, with a regular linear part
    double condition = 1; // lower bound of the condition of the linear part
    std::vector<AffineMap<Dim>> maps{};
    double longest = 0; // upper bound of all ‖B_i‖ without rounding
    int slowest = 0;    // index of the longest B_i

    // Rounding error of the B_i for |y| ≤ reach.
    double rounding(double reach) const { return linearRounding * reach + translationRounding; }
    double linearRounding = 0, translationRounding = 0;
};

// The maps U⁻¹AU, U⁻¹(w(t) − t) for the image y ↦ U y + t. nullopt when U is too near to a singular matrix.
template <int Dim>
std::optional<Conditioned<Dim>> seenFrom(const AffineMap<Dim>& image, std::span<const AffineMap<Dim>> maps);

// An image that keeps the orientation. nullopt when every map contracts as it is and no product of lengths
// underflows, or where no norm shortens the maps.
template <int Dim> std::optional<Conditioned<Dim>> conditioned(std::span<const AffineMap<Dim>> maps);

} // namespace ifs
