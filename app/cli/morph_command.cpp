// SPDX-License-Identifier: MIT
#include "options/commands.h"
#include "options/tr.h"
#include "options/usage_error.h"
#include "process/arguments.h"
#include "process/input.h"
#include "process/messages.h"
#include "process/output.h"
#include "process/progress_bar.h"

#include "animation/keys/moment.h"
#include "document/edits/timeline/morph_edits.h"
#include "document/moments/animated_fractal.h"
#include "io/fractint/entry_writer.h"

#include <QFileInfo>

#include <memory>

namespace cli {

namespace {

struct MorphArguments {
    std::string file;
    std::string from;
    std::string to;
    std::string output;
    int length = 120; // frames
    std::vector<std::string> pins;
    Verbosity verbosity;
};

// "1:3", counted from 1.
std::vector<animation::Pin> pinsOf(const std::vector<std::string>& texts) {
    std::vector<animation::Pin> pins;
    for (const std::string& text : texts) {
        const QStringList parts = QString::fromStdString(text).split(u':');
        bool areNumbers[2] = {false, false};
        int numbers[2] = {0, 0};
        for (int i = 0; i < 2 && parts.size() == 2; ++i)
            numbers[i] = parts[i].toInt(&areNumbers[i]);
        if (!areNumbers[0] || !areNumbers[1] || numbers[0] < 1 || numbers[1] < 1)
            throw UsageError{tr("--pin “%1” is not valid: it must be the numbers of two maps, such as 1:3.")
                                 .arg(QString::fromStdString(text))};
        pins.push_back({std::size_t(numbers[0] - 1), std::size_t(numbers[1] - 1)});
    }
    return pins;
}

const document::Entry* only(const ToDraw& found, const std::string& name) {
    if (found.entries.size() > 1)
        throw UsageError{
            tr("--from and --to each name one entry, not “%1”.").arg(QString::fromStdString(name))};
    return found.entries.empty() ? nullptr : found.entries.front();
}

QString sentence(document::MorphFlaw flaw, const QString& name) {
    switch (flaw) {
    case document::MorphFlaw::Measure:
        return tr("The invariant measure of “%1” has no covariance, so its maps cannot be compared with "
                  "others.")
            .arg(name);
    case document::MorphFlaw::TooMany:
        return tr("“%1” has more than 256 maps, too many for a morph.").arg(name);
    case document::MorphFlaw::Linked:
        return tr("The maps of “%1” are linked, and maps with links cannot be morphed.").arg(name);
    case document::MorphFlaw::BentCage:
        return tr("The cage of “%1” is flat or bends the picture; bake or reset it first.").arg(name);
    case document::MorphFlaw::Dimensions:
        break;
    }
    return tr("One of the entries is in the plane and the other in space.");
}

template <int Dim> std::size_t countOf(const document::Shape<Dim>* shape) {
    return shape ? shape->system.maps.size() : 0;
}

std::size_t mapCount(const document::Fractal& fractal) {
    return countOf(document::plane(fractal)) + countOf(document::space(fractal));
}

bool hasMovedBranches(const document::Fractal& fractal) {
    const auto* plane = document::plane(fractal);
    const auto* space = document::space(fractal);
    return (plane && !plane->moved.empty()) || (space && !space->moved.empty());
}

void warnOfLosses(const document::Entry& entry, const QString& fileName) {
    const QString name = printableLine(entry.fractal->name);
    if (hasMovedBranches(*entry.fractal))
        reportWarning(fileName, tr("The moved branches of “%1” are not part of the morph.").arg(name));
    const auto& appearance = entry.fractal->appearance;
    if (!appearance.mapColours.empty() || !appearance.mapBlends.empty())
        reportWarning(fileName,
                      tr("The colours of single maps of “%1” are not part of the morph.").arg(name));
    if (document::animationFacts(*entry.fractal))
        reportWarning(fileName, tr("The animation of “%1” is not part of the morph.").arg(name));
}

// Requires an .ifs file, since only the morph is written.
void checkOutput(const QString& output) {
    if (isStandardOutput(output)) return;
    if (QFileInfo(output).suffix().toLower() != QStringLiteral("ifs"))
        throw UsageError{tr("The output must be an .ifs file, and “%1” is not.").arg(output)};
}

ExitStatus morph(const MorphArguments& arguments) {
    applied(arguments.verbosity);
    checkOutput(fileNameOf(arguments.output));
    const std::vector<animation::Pin> pins = pinsOf(arguments.pins);
    const auto input = readInput(arguments.file);
    if (!input) return ExitStatus::CannotReadOrWrite;
    const ToDraw begin = entriesToDraw(*input, {arguments.from});
    const document::Entry* from = only(begin, arguments.from);
    const ToDraw end = entriesToDraw(*input, {arguments.to}, &begin);
    const document::Entry* to = only(end, arguments.to);
    if (from == nullptr || to == nullptr) return ExitStatus::InputProblems;
    for (const animation::Pin& pin : pins)
        if (pin.from >= mapCount(*from->fractal) || pin.to >= mapCount(*to->fractal))
            throw UsageError{
                tr("--pin %1:%2 names a map that does not exist.").arg(pin.from + 1).arg(pin.to + 1)};
    warnOfLosses(*from, input->name);
    if (to != from) warnOfLosses(*to, input->name);
    const document::MorphOutcome outcome =
        document::morphed(*from->fractal, *to->fractal, arguments.length, pins);
    if (!outcome.fractal) {
        const document::Entry* flawed = outcome.isOfSecond ? to : from;
        reportError(input->name, sentence(outcome.flaw, printableLine(flawed->fractal->name)));
        return ExitStatus::InputProblems;
    }
    return std::max(end.status, writeOutput(fileNameOf(arguments.output), io::writeEntry(*outcome.fractal)));
}

} // namespace

Command morphCommand() {
    auto arguments = std::make_shared<MorphArguments>();
    Command command("morph", "Write an entry whose animation turns one entry into another",
                    "morph FILE --from A --to B -o OUT.ifs [OPTION]...");
    command.more = "The entry has one map for each pair of an optimal transport between the weights. At "
                   "frame 0 its attractor and measure are those of the first entry, at the last frame "
                   "those of the second. In between, no map has a larger contraction factor than at the "
                   "worse end. Their own animations and moved branches are not part of it.";
    const OptionGroup files = command.group("Files");
    files.argument("FILE", &arguments->file, "Collection with both entries; - for standard input").required();
    files.add("-o,--output", "OUT.ifs", &arguments->output, "File to write; - for standard output")
        .completedBy(Completion::Kind::Files, {"ifs"})
        .fileName()
        .required();
    const OptionGroup group = command.group("Morph");
    group.add("--from", "NAME", &arguments->from, "The entry at frame 0: its name, or #NUMBER")
        .completedBy(Completion::Kind::Entries)
        .required();
    group.add("--to", "NAME", &arguments->to, "The entry at the last frame")
        .completedBy(Completion::Kind::Entries)
        .required();
    group.add("--length", "FRAMES", parsed(&arguments->length, integerFrom(1, animation::maxLength)),
              "The last frame", "120");
    group.add("--pin", "I:K", &arguments->pins,
              "Map I of the first becomes map K of the second, as far as their weights allow; may be "
              "repeated");
    addVerbosityOptions(command, arguments->verbosity);
    command.run = [arguments] { return morph(*arguments); };
    return command;
}

} // namespace cli
