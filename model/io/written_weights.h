// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/iterated_function_system.h"

#include <vector>

namespace io {

// The weight of every map for formats that know nothing but weights ≥ 0: as given where every map that takes
// part has one, else the probabilities; 0 for a map that is off.
std::vector<double> writtenWeights(const ifs::IteratedFunctionSystem<2>& system);

} // namespace io
