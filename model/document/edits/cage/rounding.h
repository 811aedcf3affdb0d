// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/iterated_function_system.h"

#include <algorithm>
#include <cmath>

namespace document {

// Numbers that rounding has left where there should be none would stand in the table, and in the file.
template <int Dim> void dropRounding(ifs::IteratedFunctionSystem<Dim>& system) {
    constexpr double rounding = 1e-15;
    const auto clean = [](auto& numbers, double size) {
        numbers =
            numbers.unaryExpr([size](double x) { return std::abs(x) <= rounding * size ? 0 : x; }).eval();
    };
    double reach = 0;
    for (const auto& map : system.maps)
        reach = std::max(reach, map.map.translation.cwiseAbs().maxCoeff());
    for (auto& map : system.maps) {
        clean(map.map.linear, map.map.linear.cwiseAbs().maxCoeff());
        clean(map.map.translation, reach);
    }
}

} // namespace document
