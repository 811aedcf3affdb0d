// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include <optional>
#include <vector>

namespace io {

// Says that weights rise to 1 or 100 and may be sums up to each map, and how to read them as such; nullopt
// for weights that do not, or sum to as much.
std::optional<QString> cumulativeRemark(const std::vector<std::optional<double>>& weights);

} // namespace io
