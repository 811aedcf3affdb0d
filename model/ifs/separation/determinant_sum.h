// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/existence/dyadic.h"
#include "ifs/system/affine_map.h"

#include <span>

namespace ifs {

// Σ|det A_i| − 1, without rounding.
template <int Dim> Dyadic excessOfDeterminants(std::span<const AffineMap<Dim>> maps);

// Returns true if Σ|det A_i| ≥ 1, without rounding: then the pieces cannot all be disjoint, for those of a
// neighbourhood would be, too.
template <int Dim> bool fillSpace(std::span<const AffineMap<Dim>> maps);

} // namespace ifs
