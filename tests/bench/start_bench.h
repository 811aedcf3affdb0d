// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

// From the start of the process to the first painted picture, with settings of its own.
namespace start {

struct Row {
    std::string name;
    double value = 0; // milliseconds since the start
    std::string target;
};

// The shortest of so many starts of `program`, which hands its arguments to main() below.
std::vector<Row> measure(const std::string& program, int times);

constexpr const char* argument = "--started"; // the first one of the process that is measured
int main(int argc, char** argv);

} // namespace start
