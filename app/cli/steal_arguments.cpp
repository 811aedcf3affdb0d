// SPDX-License-Identifier: MIT
#include "steal_arguments.h"

#include "options/tr.h"
#include "options/usage_error.h"
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
    if (tasks == 0 && arguments.output && !arguments.from) return StealTask::Picture; // kept transformation
    if (tasks != 1)
        throw UsageError{tr("Give one of --picture PICTURE with -o OUT.png, --map \"x,y …\" or --tear EPS.")};
    return arguments.picture ? StealTask::Picture : arguments.map ? StealTask::Map : StealTask::Tear;
}

document::TheftMode modeArgument(const std::string&, const std::string& text) {
    if (const auto mode = ifs::named<document::TheftMode>(text)) return *mode;
    throw UsageError{tr("--mode “%1” is not valid: it must be steal, transform, grid, reduce or posterise.")
                         .arg(QString::fromStdString(text))};
}

std::vector<std::size_t> orderArgument(const std::string&, const std::string& text) {
    std::vector<std::size_t> order;
    for (const QString& part : QString::fromStdString(text).split(u',')) {
        bool isNumber = false;
        const int number = part.trimmed().toInt(&isNumber);
        if (!isNumber || number < 1)
            throw UsageError{
                tr("--order “%1” is not valid: it must be the numbers of the maps, the one on top "
                   "first, such as 2,1,3.")
                    .arg(QString::fromStdString(text))};
        order.push_back(std::size_t(number - 1));
    }
    return order;
}

// A view of the plane.
NumberList planeViewArgument(const std::string& option, const std::string& text) {
    viewArgument(option, text);
    return numbersArgument(option, text);
}

void refuseForNumbers(const StealArguments& arguments) {
    refuseIf(arguments.output.has_value(), "-o", tr("--map and --tear draw no picture."));
    arguments.shown.given.refuse(
        {"--exact", "--mode", "--picture-view", "--view", "--points", "--background"},
        tr("--map and --tear draw no picture."));
}

void checkPicture(const StealArguments& arguments) {
    refuseIf(arguments.isJson, "--json", tr("it prints what --map and --tear find."));
    if (!arguments.output) throw UsageError{tr("-o OUT.png is missing: it names the picture to write.")};
    const QString output = fileNameOf(*arguments.output);
    if (!isStandardOutput(output) && QFileInfo(output).suffix().toLower() != QStringLiteral("png"))
        throw UsageError{tr("The output must be a .png file, and “%1” is not.").arg(output)};
    refuseIf(arguments.isExact && arguments.shown.points, "--points", tr("--exact draws without samples."));
    refuseIf(arguments.shown.view && arguments.shown.size.isEmpty(), "--size with one side",
             tr("--view has no proportions; give both sides."));
    refuseIf(arguments.pictureView && arguments.mode && arguments.mode != document::TheftMode::StealColours,
             "--picture-view", tr("only --mode steal places the picture."));
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
    if (arguments.order) theft.order = *arguments.order;
    if (arguments.mode) theft.mode = *arguments.mode;
    if (arguments.picture) {
        theft.picture.clear();
        theft.embedded.clear();
    }
    if (arguments.picture && !arguments.from) theft.view.reset(); // view of the kept picture
    return theft;
}

StealTask checked(const StealArguments& arguments) {
    const StealTask task = taskOf(arguments);
    if (arguments.file == "-" && arguments.fromFile == "-")
        throw UsageError{tr("Only one of the files can be standard input.")};
    refuseIf(arguments.fromFile && !arguments.from, "--from-file", tr("it applies only with --from."));
    if (task == StealTask::Picture)
        checkPicture(arguments);
    else
        refuseForNumbers(arguments);
    if (arguments.shown.simd) selectInstructions(*arguments.shown.simd);
    return task;
}

namespace {

void addPictureOptions(Command& command, StealArguments& arguments) {
    const OptionGroup group = command.group("Picture");
    group
        .add("--picture", "PICTURE", &arguments.picture,
             "Picture on the second entry: PNG, JPEG, WebP, TIFF, OpenEXR, GIF, BMP or PNM")
        .moreOf("It has up to 32 million pixels.")
        .completedBy(Completion::Kind::Files)
        .fileName();
    group
        .add("--picture-view", "CX,CY,HEIGHT", parsed(&arguments.pictureView, viewArgument),
             "What the picture shows of the second entry", "all of it, with a margin of 5 %")
        .moreOf("No colours are taken from outside it.");
    addSizeOption(group, arguments.shown.size);
    group.add("--view", "CX,CY,HEIGHT", parsed(&arguments.shown.view, planeViewArgument),
              "Centre and height of the view", "all of the fractal");
    addBackgroundOption(group, arguments.shown.background);
    group
        .flag("--exact", &arguments.isExact,
              "Go through all addresses down to the pixels instead of drawing samples")
        .moreOf("No pixel is missed.");
    group.add("--points", "N", parsed(&arguments.shown.points, countFrom(1, attractor::KeyTops::maxPoints)),
              "Samples, up to 4.29e9, such as 250000, 1e9 or 2G", "100 per pixel, at least 1M");
    addSeedOption(group, arguments.shown.seed);
    addThreadsOption(group, arguments.shown.threads);
    addSimdOption(group, arguments.shown.simd);
}

} // namespace

void addStealOptions(Command& command, StealArguments& arguments) {
    command.given = &arguments.shown.given;
    const OptionGroup files = command.group("Files");
    files.argument("FILE", &arguments.file, "Collection with the entries; - for standard input").required();
    files.add("-o,--output", "OUT.png", &arguments.output, "Picture to write; - for standard output")
        .completedBy(Completion::Kind::Files, {"png"})
        .fileName();
    files
        .add("--entry", "NAME", &arguments.entry, "The entry that is drawn: its name, or #NUMBER",
             "the first that can be read")
        .completedBy(Completion::Kind::Entries);
    files
        .add("--from", "NAME", &arguments.from, "The entry that colours are taken from",
             "the partner stored with the entry, and its settings")
        .completedBy(Completion::Kind::Entries);
    files.add("--from-file", "FILE2", &arguments.fromFile, "Collection with that entry", "FILE")
        .completedBy(Completion::Kind::Files)
        .fileName();
    const OptionGroup group = command.group("Transformation");
    group.add("--order", "I,J,…", parsed(&arguments.order, orderArgument),
              "Numbers of the maps, the one on top first", "1,2,…");
    group
        .add("--mode", "MODE", parsed(&arguments.mode, modeArgument),
             "steal, transform, grid, reduce or posterise, as in the window", "steal")
        .moreOf("steal: as a picture of the second entry would show it; transform: over the box of "
                "that entry; grid: a grid in place of the picture; reduce or posterise: through the "
                "first entry and back with fewer pixels or shades.")
        .completedBy(Completion::Kind::Words, wordsOf(ifs::names<document::TheftMode>));
    group
        .add("--map", "POINTS", parsed(&arguments.map, pointListArgument),
             "Print where these points of the first entry go, and their addresses: \"x,y x,y …\"")
        .moreOf("Nothing is drawn. Addresses have up to 40 maps, or as many as double precision "
                "determines; they have a digit for each map, or numbers with spaces between them "
                "where a map has a number above 9. A point is replaced by the nearest point of the "
                "attractor, within 1e-9 of the size of the attractor; a point farther away is an "
                "error, and the command continues.");
    group
        .add("--tear", "EPS", parsed(&arguments.tear, positiveArgument),
             "Print how far neighbouring points are torn apart, at the resolution EPS")
        .moreOf("Nothing is drawn. Prints the largest diameter of the images of two pieces of the "
                "first entry whose size is at most EPS and whose distance is no larger: no jump "
                "between such pieces is larger. Also prints where, and whether the transformation is "
                "a homeomorphism, where that is proved.");
    group.flag("--json", &arguments.isJson, "Print JSON, one line for each point")
        .moreOf("Of a point {\"point\": [x, y], \"address\": \"1232...\", \"image\": [x, y]}, of the tear "
                "{\"tear\": t, \"at\": [[x, y], [x, y]], \"homeomorphism\": true|false|null}. Unknown "
                "values are null.");
    addPictureOptions(command, arguments);
    addVerbosityOptions(command, arguments.shown.verbosity);
}

} // namespace cli
