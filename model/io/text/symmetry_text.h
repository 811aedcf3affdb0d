// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/symmetry.h"
#include "notation/text/symmetry_name.h"

#include <QString>
#include <QStringView>

#include <optional>

// Symmetries as text: none, mirror, c2 … c24 (rotation), d2 … d24 (dihedral), tetrahedral, octahedral and
// icosahedral. docs/formats.md, "Barycage's comment lines".
namespace io {

using notation::NamedSymmetry;
using notation::symmetryIn;

std::optional<NamedSymmetry> symmetryNamed(QStringView text);

QString symmetryName(ifs::SymmetryGroup group, int order); // c6, mirror …, without angle and centre

// A description for people: "6-fold rotation about (0, 0)", "mirror at 30° through (1, 0)".
template <int Dim> QString symmetrySentence(const ifs::Symmetry<Dim>& symmetry);

} // namespace io
