// SPDX-License-Identifier: MIT
#include "convert/solid_arguments.h"

#include "options/options.h"
#include "options/tr.h"
#include "options/usage_error.h"
#include "process/arguments.h"
#include "process/messages.h"
#include "render/render_arguments.h"

#include "document/edits/dimension_edits.h"
#include "io/text/number.h"

#include <cmath>

namespace cli {

void addSolidOptions(Command& command, SolidArguments& arguments) {
    const OptionGroup solids = command.group("Solids");
    solids.add("--voxel", "H", &arguments.voxel,
               "Size of a voxel in mm: the surface is within √3 H of the attractor", "by --resolution");
    solids.add("--resolution", "N", &arguments.resolution, "Voxels along the longest side of the solid",
               "128");
    solids.add("--wall", "W", &arguments.wall,
               "Smallest thickness in mm; thinner parts are thickened. By default, none is");
    solids.flag("--fill", &arguments.fill, "Fill cavities that are closed off from outside");
    solids.add("--longest", "MM", &arguments.longest, "Longest side of the attractor in mm",
               "1 mm for 1 unit of the system");
    const OptionGroup dimension = command.group("Dimension");
    dimension.add(
        "--lift", "S|auto", &arguments.lift,
        "Lift systems in the plane to space: every map scales z by S; auto: by the square root of |det|");
    dimension.add("--flatten", "X,Y,Z", &arguments.flatten,
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
    if (arguments.voxel) options.voxel = positiveArgument("--voxel", *arguments.voxel);
    if (arguments.resolution)
        options.resolution =
            integerArgument("--resolution", *arguments.resolution, 1, io::SolidOptions::maxResolution);
    if (arguments.wall) options.wall = positiveArgument("--wall", *arguments.wall);
    if (arguments.longest) {
        constexpr double minLength = 1e-3, maxLength = 1e6;
        options.longest = positiveArgument("--longest", *arguments.longest);
        if (options.longest < minLength || options.longest > maxLength)
            throw UsageError{tr("--longest “%1” is not valid: it must be from 0.001 to 1000000 mm.")
                                 .arg(QString::fromStdString(*arguments.longest))};
    }
    options.fillsCavities = arguments.fill;
    return options;
}

DimensionChange dimensionChange(const SolidArguments& arguments) {
    DimensionChange change;
    change.isLift = arguments.lift.has_value();
    if (change.isLift && *arguments.lift != "auto") {
        change.scale = io::parseNumber(QString::fromStdString(*arguments.lift));
        if (!change.scale)
            throw UsageError{tr("--lift “%1” is not valid: it must be a factor for z, or auto.")
                                 .arg(QString::fromStdString(*arguments.lift))};
    }
    if (!arguments.flatten) return change;
    refuseIf(change.isLift, "--flatten", tr("--lift does the opposite."));
    const auto xyz = numbers(QString::fromStdString(*arguments.flatten));
    if (xyz.size() != 3 || ifs::Vector<3>(xyz[0], xyz[1], xyz[2]).isZero(0))
        throw UsageError{tr("--flatten “%1” is not valid: it must be a direction, such as 0,0,1.")
                             .arg(QString::fromStdString(*arguments.flatten))};
    change.flatten = ifs::Vector<3>(xyz[0], xyz[1], xyz[2]);
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
    entry.source = nullptr; // its bytes are those of another dimension
    return std::nullopt;
}

std::optional<QString> liftWarning(const document::Fractal& lifted, const DimensionChange& change) {
    if (!change.isLift || !change.scale || std::abs(*change.scale) < 1) return std::nullopt;
    return tr("“%1” has no attractor in space: its maps multiply z by %2, which does not contract.")
        .arg(lifted.name, QString::fromLatin1(io::formatNumber(*change.scale)));
}

void sayReport(const QString& lines) {
    (void)print(printable(lines).toUtf8());
}

} // namespace cli
