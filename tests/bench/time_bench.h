// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

// Animations: what a moment costs before anything is drawn.
namespace timing {

struct Row {
    std::string name;
    double value = 0;
    std::string target;
};

// The shortest of `repetitions` times each.
std::vector<Row> measure(int repetitions);

} // namespace timing
