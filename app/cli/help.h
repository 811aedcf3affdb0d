// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace cli {

// The commands, or the options of one of them by groups, each with what stands for its value and its default;
// no line is longer than 80 characters.
std::string helpText(const CLI::App& program, const CLI::App* command);

} // namespace cli
