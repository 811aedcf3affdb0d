// SPDX-License-Identifier: MIT
#include "canvas/geometry/grid_spacing.h"

#include <cmath>

namespace view {

GridSpacing gridSpacing(double pixelsPerUnit) {
    constexpr double minSpacing = 100;
    const double wanted = minSpacing / pixelsPerUnit;
    const double decade = std::pow(10, std::floor(std::log10(wanted)));
    for (const double digit : {1.0, 2.0, 5.0})
        if (digit * decade >= wanted)
            return {digit * decade, digit * decade / (digit == 2 ? 4 : 5), digit == 2 ? 4 : 5};
    return {10 * decade, 2 * decade, 5};
}

QString gridLabel(double step, double index) {
    if (index == 0) return QStringLiteral("0");
    return QString::number(step * index, 'g', 14);
}

} // namespace view
