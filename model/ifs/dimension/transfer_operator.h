// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <optional>
#include <span>
#include <stop_token>

// The growth of Falconer's singular value function over words of maps of the plane, by their action on
// functions of directions. docs/mathematics.md, "Dimensions".
namespace ifs {

// The affinity dimension, at most 2, of two or more maps that have an attractor, to 1e-6: the function found
// must be multiplied by the same factor in every direction. nullopt where it is not, or when stopped.
std::optional<double> transferDimension(std::span<const AffineMap<2>> maps, const std::stop_token& stop);

} // namespace ifs
