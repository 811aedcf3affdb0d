// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <cstddef>
#include <span>
#include <vector>

namespace ifs {

// A point that is known to be within `error` of one of a part A_j of linked maps; infinite if nothing is
// known.
struct PartPoint {
    Vector<2> point = Vector<2>::Zero();
    double error = 0;
};

// A point of each part: the map before[j] may come before j. From j, these lead to a cycle, whose maps have a
// fixed point. If its address is short, the point is also computed without rounding, which gives the error
// and replaces a result that doubles would lose.
std::vector<PartPoint> pointsOfParts(std::span<const AffineMap<2>> maps,
                                     const std::vector<std::size_t>& before);

} // namespace ifs
