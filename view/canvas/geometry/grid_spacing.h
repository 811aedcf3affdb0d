// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

namespace view {

// Distances between the lines of the grid, 1, 2 or 5 times a power of ten.
struct GridSpacing {
    double major = 1; // distance between labelled lines
    double minor = 0.2;
    int subdivisions = 5; // number of minor steps in a major one: 5, or 4 for major steps of 2·10^k
};

// Major lines at least 100 pixels apart and less than 250, minor ones a fourth or a fifth of that.
GridSpacing gridSpacing(double pixelsPerUnit);

// The number at line `index` of lines `step` apart, without the dust of multiplication: 0.3, not
// 0.30000000000000004.
QString gridLabel(double step, double index);

} // namespace view
