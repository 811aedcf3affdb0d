// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

// Systems in space against the redraw of 10⁷ samples in the plane, 1920 × 1080, one thread.
namespace space {

struct Ratio {
    std::string name;
    double value = 0;
    std::string target;
};

// The shortest of `repetitions` times each; what is compared takes turns.
std::vector<Ratio> measure(int repetitions);

} // namespace space
