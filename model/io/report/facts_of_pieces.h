// SPDX-License-Identifier: MIT
#pragma once

#include "io/report/fact.h"

namespace io {

// Dimensions, how the pieces of the attractor meet, and what follows for its measure.
template <int Dim> void addDimensions(FactRows& rows, const FactSource<Dim>& source);
template <int Dim> void addPieces(FactRows& rows, const FactSource<Dim>& source);
template <int Dim> void addMeasure(FactRows& rows, const FactSource<Dim>& source);

} // namespace io
