// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/existence/dyadic.h"
#include "ifs/system/affine_map.h"

#include <optional>
#include <span>

namespace ifs {

// Σ|det A_i| − 1, without rounding.
template <int Dim> Dyadic excessOfDeterminants(std::span<const AffineMap<Dim>> maps);

// Returns true if Σ|det A_i| ≥ 1, without rounding: then the pieces cannot all be disjoint, for those of a
// neighbourhood would be, too.
template <int Dim> bool fillSpace(std::span<const AffineMap<Dim>> maps);

// The same sum of the determinants of the A_i as they act on the affine hull of the attractor, which the maps
// must have, with a bound of what the rounding of the coefficients makes of it.
struct HullExcess {
    int dimension = 0; // of the hull
    double value = 0;  // within a relative 2⁻⁵¹
    double rounding = 0;
};

// nullopt where there is no map.
template <int Dim> std::optional<HullExcess> excessOnHull(std::span<const AffineMap<Dim>> maps);

} // namespace ifs
