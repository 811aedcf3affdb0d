// SPDX-License-Identifier: MIT
#pragma once

#include "options/exit_status.h"

#include "document/fractal_file.h"
#include "io/solid/printable_solid.h"

#include <optional>
#include <string>

// The options of `convert` that make solids of systems in space, and those that lead into space and out of
// it.
namespace cli {

struct Command;

struct Lift {
    std::optional<double> scale; // factor of z; none: the square root of |det|
};

struct SolidArguments {
    std::optional<double> voxel, wall, longest; // mm
    std::optional<int> resolution;
    std::optional<Lift> lift;
    std::optional<ifs::Vector<3>> flatten; // direction of the projection
    bool fill = false;
};

void addSolidOptions(Command& command, SolidArguments& arguments);

bool asksForVoxels(const SolidArguments& arguments);

// Throws UsageError, also for options that the format does not have: an OpenSCAD file has only --voxel.
io::SolidOptions solidOptions(const SolidArguments& arguments, bool isMesh, bool isScad);

struct DimensionChange {
    bool isLift = false;
    std::optional<double> scale; // factor of z
    std::optional<ifs::Vector<3>> flatten;

    bool isWanted() const { return isLift || flatten.has_value(); }
};
DimensionChange dimensionChange(const SolidArguments& arguments); // throws UsageError

// The entry after the change, or why there is none.
std::optional<QString> changeDimension(document::Entry& entry, const DimensionChange& change);

// Warns that a lift by a factor for z that does not contract has no attractor; nullopt: it has one.
std::optional<QString> liftWarning(const document::Fractal& lifted, const DimensionChange& change);

// Prints lines on standard output, and says it of the file where that fails.
ExitStatus sayReport(const QString& lines, const QString& fileName);

} // namespace cli
