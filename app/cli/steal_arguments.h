// SPDX-License-Identifier: MIT
#pragma once

#include "render_arguments.h"

#include <CLI/CLI.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

// The options of barycage-cli steal. What makes no sense throws UsageError.
namespace cli {

struct StealArguments {
    using Text = std::optional<std::string>;

    std::string file;
    Text fromFile;
    Text entry;
    std::string from;
    Text output, picture, map, tear, order, pictureView;
    bool isExact = false;
    bool isJson = false;
    RenderArguments shown; // --size, --view, --points, --seed, --threads, --simd, --background
};

enum class StealTask { Picture, Map, Tear };

void addStealOptions(CLI::App& command, StealArguments& arguments);
// Looks at every value before a file is read.
StealTask checked(const StealArguments& arguments);

std::vector<std::size_t> orderOf(const StealArguments& arguments); // indices; empty: as they are
double epsilonOf(const StealArguments& arguments);

} // namespace cli
