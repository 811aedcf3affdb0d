// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/iterated_function_system.h"

#include <QSize>

#include <vector>

// A solid turned in the real window into space.
namespace orbit_bench {

struct Orbit {
    std::vector<double> milliseconds; // from handing a mouse event to the window until its picture is painted
    std::vector<int> steps;           // pixels, each way, for one of that picture
};

// Move by move of one drag, in a window of that size and at the resolution that the window chooses for it.
// Needs a QApplication.
Orbit measure(const ifs::IteratedFunctionSystem<3>& system, int moves, const QSize& size = {1920, 1080});

} // namespace orbit_bench
