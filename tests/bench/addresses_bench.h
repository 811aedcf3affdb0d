// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

// Fractal tops, symmetry and linked maps, 1920 × 1080: against pictures of the same system without them.
namespace addresses {

struct Ratio {
    std::string name;
    double value = 0;
    std::string target;
};

// The shortest of `repetitions` times each; what is compared takes turns. Needs a QApplication.
std::vector<Ratio> measure(int repetitions);

} // namespace addresses
