// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <optional>
#include <span>
#include <stop_token>

// Maps of the plane that flatten it onto a line or a point. docs/mathematics.md, "Dimensions".
namespace ifs {

// Returns true if the determinant is 0 up to the rounding of the coefficients.
bool isFlat(const Matrix<2>& linear);

// The affinity dimension, at most 1, of two or more maps that are all flat, to 1e-9; they must have an
// attractor. nullopt when they are too many, when stopped, and where the sums hardly settle.
std::optional<double> rankOneDimension(std::span<const AffineMap<2>> maps, const std::stop_token& stop);

} // namespace ifs
