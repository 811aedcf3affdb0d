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
    double shift = 0;   // bound of the distance between what it shows and what it should show
    double missing = 0; // only from what it should show to what it shows
};

CopyStep inside(const CopyStep& outer, const CopyStep& inner);

// All steps that a reader of the file draws, without their places.
struct CopyExpansion {
    std::vector<CopyStep> picture;             // in pixels
    std::vector<std::vector<CopyStep>> copies; // by level: what a copy of it is made of; of level 0 nothing
    double diameter = 0;                       // of level 0, in the code's units
    double excess = HUGE_VAL; // no point of level 0, without the fibre, is further from the attractor
    double area = 0;
    Vector<2> fibre = Vector<2>::Zero(); // by which level 0 is longer at both ends than the diameter says
};

// Deviations in pixels, over all copies of level 0.
struct CopyDeviation {
    double largest = 0;
    double error = 0;   // bound of the distance between attractor and picture, both ways
    double missing = 0; // bound of the distance from the attractor to the picture
    double area = 0;    // sum
    double length = 0;  // sum of the diameters
};

// `largest`, `error` and `missing` are infinite when there are more than `maxCopies` to go through.
CopyDeviation deviation(const CopyExpansion& expansion, std::uint64_t maxCopies);

} // namespace ifs
