// SPDX-License-Identifier: MIT
#pragma once

#include "io/report/fact.h"

namespace io {

// Position and extent of the attractor: mean and covariance, box and simplex, hull.
template <int Dim> void addMoments(FactRows& rows, const FactSource<Dim>& source);
template <int Dim> void addExtents(FactRows& rows, const FactSource<Dim>& source);
template <int Dim> void addHull(FactRows& rows, const FactSource<Dim>& source);

} // namespace io
