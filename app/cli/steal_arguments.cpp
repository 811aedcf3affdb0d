// SPDX-License-Identifier: MIT
#include "steal_arguments.h"

#include "options/options.h"
#include "options/tr.h"
#include "options/usage_error.h"
#include "process/arguments.h"
#include "process/input.h"
#include "process/messages.h"
#include "process/output.h"

#include "attractor/tops/key_tops.h"

#include <QFileInfo>

namespace cli {

namespace {

StealTask taskOf(const StealArguments& arguments) {
    const int tasks =
        int(arguments.picture.has_value()) + int(arguments.map.has_value()) + int(arguments.tear.has_value());
    if (tasks == 0 && arguments.output && !arguments.from) return StealTask::Picture; // that is kept
    if (tasks != 1)
        throw UsageError{tr("Give one of --picture PICTURE with -o OUT.png, --map \"x,y …\" or --tear EPS.")};
    return arguments.picture ? StealTask::Picture : arguments.map ? StealTask::Map : StealTask::Tear;
}

document::TheftMode modeOf(const StealArguments& arguments) {
    const auto mode = document::theftModeNamed(QString::fromStdString(*arguments.mode));
    if (!mode)
        throw UsageError{
            tr("--mode “%1” is not valid: it must be steal, transform, grid, reduce or posterise.")
                .arg(QString::fromStdString(*arguments.mode))};
    return *mode;
}

std::vector<std::size_t> orderOf(const StealArguments& arguments) {
    std::vector<std::size_t> order;
    for (const QString& part : QString::fromStdString(*arguments.order).split(u',')) {
        bool isNumber = false;
        const int number = part.trimmed().toInt(&isNumber);
        if (!isNumber || number < 1)
            throw UsageError{
                tr("--order “%1” is not valid: it must be the numbers of the maps, the one on top "
                   "first, such as 2,1,3.")
                    .arg(QString::fromStdString(*arguments.order))};
        order.push_back(std::size_t(number - 1));
    }
    return order;
}

void refuseForNumbers(const StealArguments& arguments) {
    const QString reason = tr("--map and --tear draw no picture.");
    refuseIf(arguments.output.has_value(), "-o", reason);
    refuseIf(arguments.isExact, "--exact", reason);
    refuseIf(arguments.mode.has_value(), "--mode", reason);
    refuseIf(arguments.pictureView.has_value(), "--picture-view", reason);
    refuseIf(arguments.shown.view.has_value(), "--view", reason);
    refuseIf(arguments.shown.points.has_value(), "--points", reason);
    refuseIf(arguments.shown.background.has_value(), "--background", reason);
}

void checkPicture(const StealArguments& arguments) {
    refuseIf(arguments.isJson, "--json", tr("it prints what --map and --tear find."));
    if (!arguments.output) throw UsageError{tr("-o OUT.png is missing: it names the picture to write.")};
    const QString output = fileNameOf(*arguments.output);
    if (!isStandardOutput(output) && QFileInfo(output).suffix().toLower() != QStringLiteral("png"))
        throw UsageError{tr("The output must be a .png file, and “%1” is not.").arg(output)};
    refuseIf(arguments.isExact && arguments.shown.points, "--points", tr("--exact draws without samples."));
    const bool isOpen = pictureSizeArgument("--size", arguments.shown.size).isEmpty();
    if (arguments.shown.view) {
        viewArgument("--view", *arguments.shown.view);
        refuseIf(isOpen, "--size with one side", tr("--view has no proportions; give both sides."));
    }
    if (arguments.pictureView) {
        viewArgument("--picture-view", *arguments.pictureView);
        refuseIf(arguments.mode && modeOf(arguments) != document::TheftMode::StealColours, "--picture-view",
                 tr("only --mode steal places the picture."));
    }
    if (arguments.shown.points)
        countArgument("--points", *arguments.shown.points, 1, attractor::KeyTops::maxPoints);
    if (arguments.shown.background) colourArgument("--background", *arguments.shown.background);
    wholeArgument("--seed", arguments.shown.seed);
}

} // namespace

document::KeptTheft theftOf(const StealArguments& arguments, const document::Fractal& entry) {
    document::KeptTheft theft;
    if (arguments.from)
        theft.partner = QString::fromStdString(*arguments.from);
    else if (const auto kept = document::keptTheft(entry))
        theft = *kept;
    else
        throw UsageError{tr("--from NAME is missing, and “%1” has no stored fractal transformation.")
                             .arg(printableLine(entry.name))};
    if (arguments.order) theft.order = orderOf(arguments);
    if (arguments.mode) theft.mode = modeOf(arguments);
    if (arguments.picture) {
        theft.picture.clear();
        theft.embedded.clear();
    }
    if (arguments.picture && !arguments.from) theft.view.reset(); // it was of the picture that is kept
    return theft;
}

double epsilonOf(const StealArguments& arguments) {
    return positiveArgument("--tear", *arguments.tear);
}

StealTask checked(const StealArguments& arguments) {
    const StealTask task = taskOf(arguments);
    if (arguments.file == "-" && arguments.fromFile == "-")
        throw UsageError{tr("Only one of the files can be standard input.")};
    refuseIf(arguments.fromFile && !arguments.from, "--from-file", tr("it applies only with --from."));
    if (arguments.order) orderOf(arguments);
    if (arguments.mode) modeOf(arguments);
    if (task == StealTask::Picture)
        checkPicture(arguments);
    else
        refuseForNumbers(arguments);
    if (task == StealTask::Map) pointListArgument("--map", *arguments.map);
    if (task == StealTask::Tear) epsilonOf(arguments);
    if (arguments.shown.threads) integerArgument("--threads", *arguments.shown.threads, 1, 1024);
    if (arguments.shown.simd) selectInstructions(*arguments.shown.simd);
    return task;
}

namespace {

void addPictureOptions(Command& command, StealArguments& arguments) {
    const OptionGroup group = command.group("Picture");
    group
        .add("--picture", "PICTURE", &arguments.picture,
             "Picture on the second entry: PNG, JPEG, WebP, TIFF, OpenEXR, GIF, BMP or PNM")
        .fileName();
    group.add("--picture-view", "CX,CY,HEIGHT", &arguments.pictureView,
              "What the picture shows of the second entry", "all of it, with a margin of 5 %");
    group.add("--size", "WxH", &arguments.shown.size,
              "Width and height in pixels; 1200x or x900 keeps the proportions of the fractal", "1200x900");
    group.add("--view", "CX,CY,HEIGHT", &arguments.shown.view, "Centre and height of the view",
              "all of the fractal");
    group.add("--background", "COLOUR", &arguments.shown.background,
              "transparent, a name such as white, #rrggbb, or #rrggbbaa with opacity",
              "stored in the entry, else #0d1017");
    group.flag("--exact", &arguments.isExact,
               "Go through all addresses down to the pixels instead of drawing samples");
    group.add("--points", "N", &arguments.shown.points, "Samples, up to 4.29e9, such as 250000, 1e9 or 2G",
              "100 per pixel, at least 1M");
    group.add("--seed", "S", &arguments.shown.seed, "Seed of the random numbers", "1");
    group.add("-j,--threads", "N", &arguments.shown.threads, "Threads, 1 to 1024; never changes the picture",
              "all cores");
    group.add("--simd", "SET", &arguments.shown.simd,
              "Instruction set: scalar, sse4, avx2, avx512 or neon; never changes the picture",
              "the fastest");
}

} // namespace

void addStealOptions(Command& command, StealArguments& arguments) {
    const OptionGroup files = command.group("Files");
    files.argument("FILE", &arguments.file, "Collection with the entries; - for standard input").required();
    files.add("-o,--output", "OUT.png", &arguments.output, "Picture to write; - for standard output")
        .fileName();
    files.add("--entry", "NAME", &arguments.entry, "The entry that is drawn: its name, or #NUMBER",
              "the first that can be read");
    files.add("--from", "NAME", &arguments.from, "The entry that colours are taken from",
              "the partner stored with the entry, and its settings");
    files.add("--from-file", "FILE2", &arguments.fromFile, "Collection with that entry", "FILE").fileName();
    const OptionGroup group = command.group("Transformation");
    group.add("--order", "I,J,…", &arguments.order, "Numbers of the maps, the one on top first", "1,2,…");
    group.add("--mode", "MODE", &arguments.mode,
              "steal, transform, grid, reduce or posterise, as in the window", "steal");
    group.add("--map", "POINTS", &arguments.map,
              "Print where these points of the first entry go, and their addresses: \"x,y x,y …\"");
    group.add("--tear", "EPS", &arguments.tear,
              "Print how far neighbouring points are torn apart, at the resolution EPS");
    group.flag("--json", &arguments.isJson, "Print JSON, one line for each point");
    addPictureOptions(command, arguments);
    addVerbosityOptions(command, arguments.shown.verbosity);
}

} // namespace cli
