// SPDX-License-Identifier: MIT
#include "animate_arguments.h"

#include "arguments.h"
#include "input.h"
#include "output.h"
#include "usage_error.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QRegularExpression>

#include <algorithm>

namespace cli {

namespace {

constexpr int maxChunks = 1'000'000;

QString tr(const char* text) {
    return QCoreApplication::translate("cli", text);
}

// "1-240x2,300"
std::vector<FileRange> rangesOf(const std::string& text) {
    static const QRegularExpression form(
        QStringLiteral("^\\s*([0-9]{1,7})(?:-([0-9]{1,7})(?:x([0-9]{1,7}))?)?\\s*$"));
    std::vector<FileRange> ranges;
    for (const QString& part : QString::fromStdString(text).split(u',')) {
        const auto match = form.match(part);
        FileRange range;
        range.first = range.last = match.captured(1).toInt();
        if (!match.captured(2).isEmpty()) range.last = match.captured(2).toInt();
        if (!match.captured(3).isEmpty()) range.step = match.captured(3).toInt();
        if (!match.hasMatch() || range.first < 1 || range.last < range.first || range.step < 1)
            throw UsageError{
                tr("--frames “%1” is not valid: it must be numbers of files from 1 on and rising "
                   "ranges, such as 7, 1-240, 1-240x2 or 1-48,60.")
                    .arg(QString::fromStdString(text))};
        ranges.push_back(range);
    }
    return ranges;
}

Chunk chunkOf(const std::string& text) {
    const QStringList parts = QString::fromStdString(text).split(u'/');
    bool areNumbers[2] = {false, false};
    Chunk chunk;
    if (parts.size() == 2) chunk = {parts[0].toInt(&areNumbers[0]), parts[1].toInt(&areNumbers[1])};
    if (!areNumbers[0] || !areNumbers[1] || chunk.i < 0 || chunk.i >= chunk.n || chunk.n > maxChunks)
        throw UsageError{tr("--chunk “%1” is not valid: it must be i/n with i from 0 to n - 1, such as 0/6.")
                             .arg(QString::fromStdString(text))};
    return chunk;
}

void checkOutput(const QString& output) {
    if (QFileInfo(output).suffix().toLower() != u"png" || isStandardOutput(output))
        throw UsageError{
            tr("The frames of an animation are written to .png files, such as NAME.####.png, and “%1” is not "
               "one.")
                .arg(output)};
    const QString name = QFileInfo(output).fileName();
    static const QRegularExpression groups(QStringLiteral("(?<!#)#")); // count() lets matches overlap
    if (name.count(groups) != 1 || output.count(u'#') != name.count(u'#'))
        throw UsageError{tr("The name of the output must have one group of #, which stands for the number of "
                            "the frame, such as NAME.####.png.")};
}

} // namespace

void addAnimateOptions(CLI::App& command, AnimateArguments& arguments) {
    command
        .add_option("FILE", arguments.file,
                    "Collection, or picture with an embedded system; - for standard input")
        ->type_name("FILE")
        ->group("Files")
        ->required();
    command
        .add_option("-o,--output", arguments.picture.output,
                    "Pictures to write, such as NAME.####.png: #### is the number of the frame plus 1, with "
                    "zeros in front")
        ->type_name("NAME.####.png")
        ->group("Files")
        ->required();
    addEntriesOption(command, arguments.picture.entries, "the first with an animation")
        ->description("The entry: its name, or #NUMBER");
    const auto add = [&](const char* name, const char* shown, auto& value, const char* description,
                         const char* standard) {
        command.add_option(name, value, description)
            ->type_name(shown)
            ->default_str(standard)
            ->group("Frames");
    };
    add("--frames", "LIST", arguments.frames,
        "Only these numbers of files, counted from 1: a-b, every x-th with a-bxX, and lists of them", "all");
    add("--chunk", "I/N", arguments.chunk, "Only every N-th of them, from the I-th on, counted from 0",
        "0/1");
    add("--existing", "WHAT", arguments.existing,
        "What happens to files that exist: skip those that are complete and of the same request, replace "
        "them, or fail",
        "skip");
    addFrameOptions(command, arguments.picture);
    command.get_option("--points")->description("Samples of each frame, such as 250000, 1e9 or 2G");
    addVerbosityOptions(command, arguments.picture.verbosity);
}

void check(AnimateArguments& arguments) {
    checkOutput(fileNameOf(arguments.picture.output));
    checked(arguments.picture);
    if (arguments.picture.entries.size() > 1 || arguments.picture.entries == std::vector<std::string>{"all"})
        throw UsageError{tr("The frames are of one entry: give --entry once, with its name or number.")};
    if (arguments.frames) arguments.ranges = rangesOf(*arguments.frames);
    if (arguments.chunk) arguments.part = chunkOf(*arguments.chunk);
    const std::string existing =
        choiceArgument("--existing", arguments.existing, {"skip", "replace", "fail"});
    arguments.whatExists = existing == "skip"      ? Existing::Skip
                           : existing == "replace" ? Existing::Replace
                                                   : Existing::Fail;
}

std::vector<int> filesIn(const std::vector<FileRange>& ranges, int count) {
    std::vector<bool> isWanted(std::size_t(count) + 1, ranges.empty());
    for (const FileRange& range : ranges)
        for (int number = range.first; number <= std::min(range.last, count); number += range.step)
            isWanted[std::size_t(number)] = true;
    std::vector<int> numbers;
    for (int number = 1; number <= count; ++number)
        if (isWanted[std::size_t(number)]) numbers.push_back(number);
    return numbers;
}

bool isAnyBeyond(const std::vector<FileRange>& ranges, int count) {
    return std::ranges::any_of(ranges, [count](const FileRange& range) {
        return range.last - (range.last - range.first) % range.step > count;
    });
}

QString numbered(const QString& pattern, int number) {
    const qsizetype first = pattern.indexOf(u'#');
    const qsizetype width = pattern.count(u'#');
    return QString(pattern).replace(first, width, QString::number(number).rightJustified(width, u'0'));
}

} // namespace cli
