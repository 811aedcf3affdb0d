// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/iterated_function_system.h"

#include <QString>

#include <optional>
#include <vector>

namespace io {

// The weight of every map for formats that know nothing but weights ≥ 0: as given where every map that takes
// part has one, else the probabilities; 0 for a map that is off.
template <int Dim> std::vector<double> exportWeights(const ifs::IteratedFunctionSystem<Dim>& system);

// A remark on a weight that was read and switches its map, counted from 1, off.
std::optional<QString> weightRemark(std::size_t map, double weight);

// Remarks on a map without a weight, counted from 1, where others have one.
QString missingWeightRemark(std::size_t map);

} // namespace io
