// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/symmetry.h"

#include <QString>
#include <QStringView>

#include <optional>
#include <vector>

// Symmetries as text: none, mirror, c2 … c24 (rotation), d2 … d24 (dihedral), tetrahedral, octahedral and
// icosahedral. docs/formats.md, "Barycage's comment lines".
namespace io {

// NAME[:DEGREES][@X,Y[,Z]], before the dimension is known.
struct NamedSymmetry {
    ifs::SymmetryGroup group = ifs::SymmetryGroup::None;
    int order = 1;
    std::optional<double> angle;
    std::vector<double> centre; // two or three coordinates, or none
};
std::optional<NamedSymmetry> symmetryNamed(QStringView text);

// The symmetry, at the origin if no centre is given; a centre in the plane is at height 0 in space. nullopt
// when the group or the centre does not belong to this dimension.
template <int Dim> std::optional<ifs::Symmetry<Dim>> symmetryIn(const NamedSymmetry& named);

QString symmetryName(ifs::SymmetryGroup group, int order); // c6, mirror …, without angle and centre

// A description for people: "6-fold rotation about (0, 0)", "mirror at 30° through (1, 0)".
template <int Dim> QString symmetrySentence(const ifs::Symmetry<Dim>& symmetry);

} // namespace io
