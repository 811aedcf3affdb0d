// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "ifs/extent/extent.h"

#include <QString>

// Texts of the Cage panel.
namespace view {

// The state of the cage as a sentence: at rest, placed, mirrored, bent or flat. `cage` is the one in force of
// the fractal.
QString cageStatus(const document::Fractal& fractal, const ifs::ControlCage<2>& cage);
QString cageStatus(const document::Fractal& fractal, const ifs::ControlCage<3>& cage);

// Rounding error of a coordinate that should be 0, at the size of the cage.
template <int Dim> double roundingIn(const ifs::ControlCage<Dim>& cage);

// The barycentric coordinates of the point, or why the cage gives it none.
template <int Dim> QString barycentricText(const ifs::ControlCage<Dim>& cage, const ifs::Vector<Dim>& point);

// The minimal canonical simplex of the displayed picture, or why there is none. Takes long; any thread.
QString enclosingSimplexText(const document::Fractal& fractal);

// The pattern with the vertex, counted from 1, and its coordinates in the place of %1, %2 …
template <int Dim>
QString stepText(const QString& pattern, std::size_t vertex, const ifs::Vector<Dim>& position);

} // namespace view
