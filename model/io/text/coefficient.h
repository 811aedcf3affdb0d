// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"
#include "notation/text/number.h"

namespace io {

using notation::isCoefficient;
using notation::maxCoefficient;

inline bool isCoefficient(const ifs::AffineMap<2>& map) {
    return (map.linear.array().abs() <= maxCoefficient).all() &&
           (map.translation.array().abs() <= maxCoefficient).all();
}

} // namespace io
