// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

namespace animation {

constexpr double safety = 1e-12; // distance that a norm must keep below 1

// Returns true if the map contracts in the Euclidean norm, by the margin `safety`.
template <int Dim> bool contracts(const ifs::AffineMap<Dim>& map) {
    return map.linear.squaredNorm() < 1 - safety || ifs::spectralNorm<Dim>(map.linear) < 1 - safety;
}

} // namespace animation
