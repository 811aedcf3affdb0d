// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <cmath>
#include <limits>

namespace io {

// The largest number of Fractint; every reader refuses larger ones, and infinities and NaN.
constexpr double maxCoefficient = std::numeric_limits<float>::max();

inline bool isCoefficient(double number) {
    return std::abs(number) <= maxCoefficient;
}

inline bool isCoefficient(const ifs::AffineMap<2>& map) {
    return (map.linear.array().abs() <= maxCoefficient).all() &&
           (map.translation.array().abs() <= maxCoefficient).all();
}

} // namespace io
