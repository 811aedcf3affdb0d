// SPDX-License-Identifier: MIT
#pragma once

#include "render/render_arguments.h"

#include "document/tops/kept_theft.h"

#include <optional>
#include <string>
#include <vector>

// The options of barycage-cli steal. What makes no sense throws UsageError.
namespace cli {

struct Command;

struct StealArguments {
    using Text = std::optional<std::string>;

    std::string file;
    Text fromFile;
    Text entry, from; // no `from`: the transformation kept in the entry
    Text output, picture;
    std::optional<std::vector<ifs::Vector<2>>> map; // points
    std::optional<double> tear;                     // the resolution
    std::optional<std::vector<std::size_t>> order;  // indices of maps
    std::optional<document::TheftMode> mode;
    std::optional<attractor::View> pictureView;
    bool isExact = false;
    bool isJson = false;
    RenderArguments shown; // --size, --view, --points, --seed, --threads, --simd, --background
};

enum class StealTask { Picture, Map, Tear };

void addStealOptions(Command& command, StealArguments& arguments);
// Checks every value before a file is read.
StealTask checked(const StealArguments& arguments);

// The requested transformation, or without --from the one that the entry keeps, with the requested changes.
// The path of a kept picture is relative to the folder of the file; it is empty where --picture names
// another.
document::KeptTheft theftOf(const StealArguments& arguments, const document::Fractal& entry);

} // namespace cli
