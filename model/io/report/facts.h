// SPDX-License-Identifier: MIT
#pragma once

#include "io/report/fact.h"

namespace io {

// A row for each fact, in the order of the report.
template <int Dim> FactRows facts(const FactSource<Dim>& source);

} // namespace io
