// SPDX-License-Identifier: MIT
#pragma once

#include "io/report/fact.h"

namespace io {

// The maps themselves, whether they have an attractor, and what each of them does.
template <int Dim> void addMapFacts(FactRows& rows, const FactSource<Dim>& source);

// Further parts of an entry: a symmetry, links, a cage.
template <int Dim> void addEntryFacts(FactRows& rows, const FactSource<Dim>& source);

} // namespace io
