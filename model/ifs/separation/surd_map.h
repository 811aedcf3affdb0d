// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/numbers/surd.h"
#include "ifs/system/affine_map.h"
#include "ifs/system/branch.h"
#include "ifs/system/iterated_function_system.h"

#include <optional>
#include <span>
#include <vector>

namespace ifs {

// x ↦ Ax + b in 1 to 3 dimensions, without rounding.
struct SurdMap {
    std::vector<std::vector<Surd>> linear; // row by row
    std::vector<Surd> translation;

    std::size_t dimension() const { return translation.size(); }
    bool hasValue() const; // true if all its numbers have values

    friend bool operator==(const SurdMap&, const SurdMap&) = default;
};

SurdMap identity(std::size_t dimension);
SurdMap operator*(const SurdMap& outer, const SurdMap& inner);
SurdMap inverse(const SurdMap& map); // without value if singular
// The s² of a map with AᵀA = s²I; nullopt where it is no similarity.
std::optional<Surd> squaredRatio(const SurdMap& map);
Surd determinant(const SurdMap& map);
SurdMap word(std::span<const SurdMap> maps, const Word& word);

// The map restricted to the coordinates along these axes: its action on the affine hull of the attractor.
// nullopt if the map does not leave the axes alone, or moves that hull.
std::optional<SurdMap> restricted(const SurdMap& map, std::span<const int> axes);

// The active maps as they are typed; numbers without a typed form are those stored. Empty if nothing differs
// from the stored numbers, one of the numbers is too long, or maps are copied by a symmetry.
template <int Dim>
std::vector<SurdMap> typedMaps(const IteratedFunctionSystem<Dim>& system, const ActiveMaps<Dim>& active);

} // namespace ifs
