// SPDX-License-Identifier: MIT
#include "animate/animate_arguments.h"

#include "options/options.h"
#include "options/tr.h"
#include "options/usage_error.h"
#include "process/input.h"
#include "process/output.h"
#include "process/picture_suffixes.h"

#include <QFileInfo>
#include <QRegularExpression>

#include <algorithm>

namespace cli {

namespace {

constexpr int maxChunks = 1'000'000;

Chunk chunkArgument(const std::string&, const std::string& text) {
    const QStringList parts = QString::fromStdString(text).split(u'/');
    bool areNumbers[2] = {false, false};
    Chunk chunk;
    if (parts.size() == 2) chunk = {parts[0].toInt(&areNumbers[0]), parts[1].toInt(&areNumbers[1])};
    if (!areNumbers[0] || !areNumbers[1] || chunk.i < 0 || chunk.i >= chunk.n || chunk.n > maxChunks)
        throw UsageError{tr("--chunk “%1” is not valid: it must be i/n with i from 0 to n - 1, such as 0/6.")
                             .arg(QString::fromStdString(text))};
    return chunk;
}

// Refuses options for pictures that a video does not have.
void refuseForVideo(const AnimateArguments& arguments) {
    refuseIf(arguments.chunk.has_value(), "--chunk",
             tr("only one process can write a video. Draw the frames as NAME.####.png, and make the video "
                "from them with encode."));
    refuseIf(arguments.existing == Existing::Skip, "--existing skip",
             tr("a video is written in one piece. Frames written as NAME.####.png can be skipped."));
    refuseIf(is16Bit(arguments.picture), "--bits 16", tr("videos have 8 bits per channel."));
    refuseIf(arguments.picture.dpi.has_value(), "--dpi", tr("videos have no resolution."));
}

} // namespace

void addAnimateOptions(Command& command, AnimateArguments& arguments) {
    const OptionGroup files = command.group("Files");
    files
        .argument("FILE", &arguments.file,
                  "Collection, or picture with an embedded system; - for standard input")
        .required();
    files
        .add("-o,--output", "OUT", &arguments.picture.output,
             "Pictures to write, such as NAME.####.png: #### is the number of the frame plus 1, with "
             "leading zeros; or a video: " +
                 namedVideos(tr("or")).toStdString())
        .moreOf("A folder that does not exist is created. " + describedVideos() +
                " A video contains the entry, and Barycage can open it again as an animation.")
        .completedBy(Completion::Kind::Files, videoSuffixes({"png"}))
        .is(Work)
        .fileName()
        .required();
    addEntriesOption(command, arguments.picture.entries, "the first with an animation")
        .is(Work) // a request holds the entry itself
        .description = "The entry: its name, or #NUMBER";
    const OptionGroup frames = command.group("Frames");
    frames
        .add("--frames", "LIST", parsed(&arguments.ranges, rangesArgument),
             "Only these numbers of files, counted from 1: a-b, every x-th with a-bxX, and lists of them",
             "all")
        .moreOf("A warning is printed if some are after the last frame.")
        .is(Work);
    frames
        .add("--chunk", "I/N", parsed(&arguments.chunk, chunkArgument),
             "Only every N-th of them, from the I-th on, counted from 0", "0/1")
        .is(Work);
    frames
        .add("--existing", "WHAT", choice(&arguments.existing),
             "What happens to files that exist: skip keeps those that are complete and of the same request, "
             "and replaces the others with a warning; replace replaces all; fail draws nothing",
             "skip; for a video replace")
        .moreOf("The warning says how many. A video is never skipped.")
        .is(Work);
    frames
        .add("--fps", "R", parsed(&arguments.framesPerSecond, rateArgument),
             "Frames per second of a video, such as 24, 29.97 or 30000/1001", "those of the animation")
        .is(Work);
    frames
        .add("--shutter", "DEG", parsed(&arguments.picture.shutter, shutterArgument),
             "Motion blur: the angle for which the shutter is open around each frame, 0 to 360; 180 is "
             "half the time of a frame",
             "0")
        .is(Picture);
    frames
        .add("--exposure", "HOW", choice(&arguments.picture.exposure),
             "Brightness: smooth follows the whole animation without flicker, fixed is that of frame 0, each "
             "is measured separately for every frame",
             "smooth")
        .moreOf("Smooth is measured at the keys and half way between them; each is what render does.")
        .is(Picture);
    addFrameOptions(command, arguments.picture);
    command.option("--points").description = "Samples of each frame, such as 250000, 1e9 or 2G";
    addVerbosityOptions(command, arguments.picture.verbosity);
}

void check(AnimateArguments& arguments) {
    const QString output = fileNameOf(arguments.picture.output);
    arguments.video = io::videoFormat(QFileInfo(output).suffix());
    if (!arguments.video)
        checkPattern(output);
    else if (QFileInfo(output).fileName().contains(u'#'))
        throw UsageError{
            tr("A video is one file, and the # in “%1” stands for the numbers of frames.").arg(output)};
    if (arguments.video) arguments.picture.format = "png"; // format of the frames, which are never written
    checked(arguments.picture);
    if (arguments.video)
        refuseForVideo(arguments);
    else
        refuseIf(arguments.framesPerSecond.has_value(), "--fps", tr("it applies only to videos."));
    if (arguments.picture.entries.size() > 1 || arguments.picture.entries == std::vector<std::string>{"all"})
        throw UsageError{tr("The frames are of one entry: give --entry once, with its name or number.")};
    arguments.whatExists = arguments.existing.value_or(arguments.video ? Existing::Replace : Existing::Skip);
}

std::vector<FileRange> rangesArgument(const std::string&, const std::string& text) {
    if (text == "all") return {};
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
            throw UsageError{tr("--frames “%1” is not valid: it must be file numbers, counted from 1, or "
                                "ascending ranges, such as 7, 1-240, 1-240x2 or 1-48,60.")
                                 .arg(QString::fromStdString(text))};
        ranges.push_back(range);
    }
    return ranges;
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

void checkPattern(const QString& pattern) {
    if (QFileInfo(pattern).suffix().toLower() != u"png" || isStandardOutput(pattern))
        throw UsageError{
            tr("The frames of an animation are written to .png files, such as NAME.####.png, or to a video "
               "(%1), and “%2” is none of them.")
                .arg(namedVideos(tr("or")), pattern)};
    const QString name = QFileInfo(pattern).fileName();
    // Look-behind: count() lets matches overlap.
    static const QRegularExpression groups(QStringLiteral("(?<!#)#"));
    if (name.count(groups) != 1)
        throw UsageError{
            tr("The name of the pictures must have one group of #, which stands for the number of "
               "the frame, such as NAME.####.png.")};
}

QString numbered(const QString& pattern, int number) {
    const qsizetype width = QFileInfo(pattern).fileName().count(u'#');
    const qsizetype first = pattern.lastIndexOf(u'#') + 1 - width;
    return QString(pattern).replace(first, width, QString::number(number).rightJustified(width, u'0'));
}

} // namespace cli
