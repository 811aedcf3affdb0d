// SPDX-License-Identifier: MIT
#include "convert/solid_arguments.h"

#include "options/tr.h"
#include "options/usage_error.h"
#include "process/arguments.h"
#include "process/messages.h"

#include "document/edits/dimension_edits.h"
#include "io/file/standard_output.h"
#include "io/text/number.h"

#include <cerrno>
#include <cmath>

namespace cli {

namespace {

double lengthArgument(const std::string& option, const std::string& text) {
    constexpr double minLength = 1e-3, maxLength = 1e6;
    const double length = positiveArgument(option, text);
    if (length >= minLength && length <= maxLength) return length;
    throw UsageError{tr("--longest “%1” is not valid: it must be from 0.001 to 1000000 mm.")
                         .arg(QString::fromStdString(text))};
}

Lift liftArgument(const std::string&, const std::string& text) {
    if (text == "auto") return {};
    if (const auto scale = io::parseNumber(QString::fromStdString(text))) return {scale};
    throw UsageError{tr("--lift “%1” is not valid: it must be a factor for z, or auto.")
                         .arg(QString::fromStdString(text))};
}

ifs::Vector<3> directionArgument(const std::string&, const std::string& text) {
    const auto xyz = numbers(QString::fromStdString(text));
    if (xyz.size() != 3 || ifs::Vector<3>(xyz[0], xyz[1], xyz[2]).isZero(0))
        throw UsageError{tr("--flatten “%1” is not valid: it must be a direction, such as 0,0,1.")
                             .arg(QString::fromStdString(text))};
    return {xyz[0], xyz[1], xyz[2]};
}

} // namespace

void addSolidOptions(Command& command, SolidArguments& arguments) {
    const OptionGroup solids = command.group("Solids");
    solids
        .add("--voxel", "H", parsed(&arguments.voxel, positiveArgument),
             "Size of a voxel in mm: the surface is within √3 H of the attractor", "by --resolution")
        .moreOf("In .scad files it is the largest size of a part.");
    solids.add("--resolution", "N",
               parsed(&arguments.resolution, integerFrom(1, io::SolidOptions::maxResolution)),
               "Voxels along the longest side of the solid", "128");
    solids.add("--wall", "W", parsed(&arguments.wall, positiveArgument),
               "Smallest thickness in mm; thinner parts are thickened. By default, none is");
    solids.flag("--fill", &arguments.fill, "Fill cavities that are closed off from outside");
    solids.add("--longest", "MM", parsed(&arguments.longest, lengthArgument),
               "Longest side of the attractor in mm", "1 mm for 1 unit of the system");
    const OptionGroup dimension = command.group("Dimension");
    dimension
        .add("--lift", "S|auto", parsed(&arguments.lift, liftArgument),
             "Lift systems in the plane to space: every map scales z by S; auto: by the square root of |det|")
        .completedBy(Completion::Kind::Words, {"auto"});
    dimension.add("--flatten", "X,Y,Z", parsed(&arguments.flatten, directionArgument),
                  "Project systems in space to the plane, along a direction that every map keeps");
}

bool asksForVoxels(const SolidArguments& arguments) {
    return arguments.voxel || arguments.resolution;
}

io::SolidOptions solidOptions(const SolidArguments& arguments, bool isMesh, bool isScad) {
    const QString reason = tr("it applies only to solids: .stl, .obj, .glb and .ply.");
    refuseIf(arguments.voxel && !isMesh && !isScad, "--voxel", reason);
    refuseIf(arguments.resolution && !isMesh, "--resolution", reason);
    refuseIf(arguments.wall && !isMesh, "--wall", reason);
    refuseIf(arguments.fill && !isMesh, "--fill", reason);
    refuseIf(arguments.longest && !isMesh, "--longest", reason);
    refuseIf(arguments.voxel && arguments.resolution, "--resolution",
             tr("--voxel already gives the size of the voxels."));
    io::SolidOptions options;
    if (arguments.voxel) options.voxel = *arguments.voxel;
    if (arguments.resolution) options.resolution = *arguments.resolution;
    if (arguments.wall) options.wall = *arguments.wall;
    if (arguments.longest) options.longest = *arguments.longest;
    options.fillsCavities = arguments.fill;
    return options;
}

DimensionChange dimensionChange(const SolidArguments& arguments) {
    refuseIf(arguments.lift && arguments.flatten, "--flatten", tr("--lift does the opposite."));
    DimensionChange change;
    change.isLift = arguments.lift.has_value();
    if (arguments.lift) change.scale = arguments.lift->scale;
    change.flatten = arguments.flatten;
    return change;
}

std::optional<QString> changeDimension(document::Entry& entry, const DimensionChange& change) {
    if (!change.isWanted()) return std::nullopt;
    const document::Fractal& fractal = *entry.fractal;
    const QString obstacle =
        change.isLift ? document::liftObstacle(fractal) : document::flattenObstacle(fractal, *change.flatten);
    if (!obstacle.isEmpty()) return obstacle;
    auto changed = change.isLift ? document::lifted(fractal, change.scale)
                                 : document::flattened(fractal, *change.flatten);
    entry.fractal = std::make_shared<const document::Fractal>(*std::move(changed));
    entry.source = nullptr; // its bytes are an entry of the other dimension
    return std::nullopt;
}

std::optional<QString> liftWarning(const document::Fractal& lifted, const DimensionChange& change) {
    if (!change.isLift || !change.scale || std::abs(*change.scale) < 1) return std::nullopt;
    return tr("“%1” has no attractor in space: its maps multiply z by %2, which does not contract.")
        .arg(lifted.name, QString::fromLatin1(io::formatNumber(*change.scale)));
}

ExitStatus sayReport(const QString& lines, const QString& fileName) {
    if (print(printable(lines).toUtf8())) return ExitStatus::Done;
    reportError(fileName, io::cannotPrint(errno));
    return ExitStatus::CannotReadOrWrite;
}

} // namespace cli
