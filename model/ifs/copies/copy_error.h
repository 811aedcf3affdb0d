// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"

#include <cmath>
#include <cstdint>
#include <vector>

// Distance between an attractor and a picture that is put together from copies of it.
namespace ifs {

// A copy as the error sees it.
struct CopyStep {
    Matrix<2> linear = Matrix<2>::Identity();
    int level = 0;
    bool isProjection = false;
    double shift = 0;   // bound of the distance between the shown and the intended set
    double missing = 0; // bound of the distance from the intended to the shown set alone
};

CopyStep inside(const CopyStep& outer, const CopyStep& inner);

// All steps that a reader of the file draws, without their places.
struct CopyExpansion {
    std::vector<CopyStep> picture;             // steps in pixels
    std::vector<std::vector<CopyStep>> copies; // steps within a copy of each level; none for level 0
    double diameter = 0;                       // diameter of level 0 in units of the code
    // Distance from the attractor that no point of level 0, without the fibre, exceeds.
    double excess = HUGE_VAL;
    double area = 0;
    Vector<2> fibre = Vector<2>::Zero(); // vector by which level 0 extends beyond `diameter` at both ends
};

// Deviations in pixels, over all copies of level 0.
struct CopyDeviation {
    double largest = 0;
    double error = 0;   // bound of the distance between attractor and picture in both directions
    double missing = 0; // bound of the distance from the attractor to the picture
    double area = 0;    // sum of all areas
    double length = 0;  // sum of all diameters
};

// `largest`, `error` and `missing` are infinite when there are more than `maxCopies` to go through.
CopyDeviation deviation(const CopyExpansion& expansion, std::uint64_t maxCopies);

} // namespace ifs
