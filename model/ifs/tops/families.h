// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

// Systems with the same addresses for all values of their parameters, each in (0, 1): fractal transformations
// between two of one family are homeomorphisms. docs/mathematics.md, "Fractal tops".
namespace ifs {

// Four maps onto the pieces of the triangle (0, 0), (1, 0), (0, 1), whose sides are divided by α, β, γ.
std::vector<AffineMap<2>> triangleFamily(const std::array<double, 3>& parameters);
// Four maps onto the rectangles of the unit square that meet at (p, q).
std::vector<AffineMap<2>> squareFamily(const std::array<double, 2>& parameters);

// The parameters, three of a triangle or two of a square; nullopt where the maps are of neither family.
std::optional<std::vector<double>> familyParameters(std::span<const AffineMap<2>> maps);

} // namespace ifs
