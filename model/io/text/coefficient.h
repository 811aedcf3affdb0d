// SPDX-License-Identifier: MIT
#pragma once

#include "entry/text/number.h"
#include "ifs/system/affine_map.h"

namespace io {

using entry::isCoefficient;
using entry::maxCoefficient;

inline bool isCoefficient(const ifs::AffineMap<2>& map) {
    return (map.linear.array().abs() <= maxCoefficient).all() &&
           (map.translation.array().abs() <= maxCoefficient).all();
}

} // namespace io
