// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/symmetry.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Symmetries as text: none, mirror, c2 … c24 (rotation), d2 … d24 (dihedral), tetrahedral, octahedral and
// icosahedral. docs/formats.md, "Barycage's comment lines".
namespace notation {

// NAME[:DEGREES][@X,Y[,Z]], before the dimension is known.
struct NamedSymmetry {
    ifs::SymmetryGroup group = ifs::SymmetryGroup::None;
    int order = 1;
    std::optional<double> angle;
    std::vector<double> centre; // two or three coordinates, or none
};
std::optional<NamedSymmetry> symmetryNamed(std::string_view text);

// At the origin where no centre is given; a centre in the plane is at height 0 in space. nullopt when the
// group or the centre does not belong to this dimension.
template <int Dim> std::optional<ifs::Symmetry<Dim>> symmetryIn(const NamedSymmetry& named);

std::string symmetryName(ifs::SymmetryGroup group, int order); // c6, mirror …, without angle and centre

} // namespace notation
