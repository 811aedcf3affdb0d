// SPDX-License-Identifier: MIT
#pragma once

#include "io/report/fact.h"

namespace io {

// Dimensions, the contacts of the pieces of the attractor, and consequences for its measure.
template <int Dim> void addDimensions(FactRows& rows, const FactSource<Dim>& source);
template <int Dim> void addPieces(FactRows& rows, const FactSource<Dim>& source);
template <int Dim> void addMeasure(FactRows& rows, const FactSource<Dim>& source);

} // namespace io
