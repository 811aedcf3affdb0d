// SPDX-License-Identifier: MIT
#include "render/picture_parts.h"

#include "options/commands.h"
#include "options/tr.h"
#include "options/usage_error.h"
#include "process/arguments.h"
#include "process/input.h"
#include "process/interrupt.h"
#include "process/messages.h"
#include "process/output.h"
#include "process/output_names.h"
#include "process/progress_bar.h"

#include "io/file/standard_output.h"
#include "io/picture/picture_writers.h"

#include <QFileInfo>

#include <memory>
#include <numeric>
#include <variant>

namespace cli {

namespace {

constexpr int maxParts = 1'000'000;

// i of n, from "i/n"; i counts from 0.
struct Share {
    int index = 0;
    int count = 1;
};
Share shareArgument(const char* option, const std::string& text) {
    const QString whole = QString::fromStdString(text);
    const QStringList numbers = whole.split(u'/');
    bool isIndex = false;
    bool isCount = false;
    const Share share{numbers.value(0).toInt(&isIndex), numbers.value(1).toInt(&isCount)};
    if (numbers.size() != 2 || !isIndex || !isCount || share.index < 0 || share.index >= share.count ||
        share.count > maxParts)
        throw UsageError{
            tr("%1 “%2” is not valid: write i/n, where n is the number of parts, at most %3, and "
               "i counts from 0 to n − 1.")
                .arg(QLatin1String(option), whole, QString::number(maxParts))};
    return share;
}

attractor::PicturePart partArgument(const RenderArguments& arguments) {
    const Share share = shareArgument("--part", arguments.part.value_or("0/1"));
    return {std::uint64_t(share.index), std::uint64_t(share.count)};
}

// Rows of pixels.
struct Rows {
    int first = 0;
    int end = 0;
};
Rows bandArgument(const RenderArguments& arguments, int height) {
    const Share share = shareArgument("--band", arguments.band.value_or("0/1"));
    const auto boundary = [&](int number) { return int(std::int64_t(height) * number / share.count); };
    const Rows rows{boundary(share.index), boundary(share.index + 1)};
    if (rows.first == rows.end)
        throw UsageError{tr("--band %1 has no rows: the height of the picture is %2.")
                             .arg(QString::fromStdString(*arguments.band))
                             .arg(height)};
    return rows;
}

bool isDivided(const RenderArguments& arguments) {
    return arguments.part || arguments.band;
}

// What the file that is resumed has decided.
void refuseWhatIsDecided(const RenderArguments& arguments) {
    const QString reason = tr("the file that --resume names already defines the picture.");
    refuseIf(!arguments.files.empty(), "FILE", reason);
    refuseIf(!arguments.entries.empty(), "--entry", reason);
    const RenderArguments standard;
    refuseIf(arguments.size != standard.size, "--size", reason);
    refuseIf(arguments.seed != standard.seed, "--seed", reason);
    const std::pair<const OptionText*, const char*> options[] = {
        {&arguments.margin, "--margin"},
        {&arguments.cage, "--cage"},
        {&arguments.restCage, "--rest-cage"},
        {&arguments.view, "--view"},
        {&arguments.palette, "--palette"},
        {&arguments.colour, "--colour"},
        {&arguments.gamma, "--gamma"},
        {&arguments.brightness, "--brightness"},
        {&arguments.contrast, "--contrast"},
        {&arguments.vibrancy, "--vibrancy"},
        {&arguments.background, "--background"},
        {&arguments.supersample, "--supersample"},
        {&arguments.bits, "--bits"},
        {&arguments.dpi, "--dpi"},
        {&arguments.viewRotation, "--view-rotation"},
        {&arguments.orbit, "--orbit"},
        {&arguments.perspective, "--perspective"},
        {&arguments.look, "--look"},
        {&arguments.light, "--light"},
        {&arguments.fog, "--fog"},
        {&arguments.slice, "--slice"},
        {&arguments.stereo, "--stereo"},
        {&arguments.frame, "--frame"},
        {&arguments.overlay, "--overlay"},
    };
    for (const auto& [value, name] : options)
        refuseIf(value->has_value(), name, reason);
    refuseIf(arguments.yDown, "--y-down", reason);
    refuseIf(arguments.legend, "--legend", reason);
}

// Where the sums or the picture go.
struct Target {
    QString output;
    std::optional<io::PictureFile> file; // none: sums
    std::optional<int> quality;
};

bool isSolid(const io::PngExport&) {
    return false;
}
bool isSolid(const io::SpaceExport& picture) {
    return !attractor::showsCloud(picture.look);
}
bool isDepth(const io::PngExport&) {
    return false;
}
bool isDepth(const io::SpaceExport& picture) {
    return picture.look == attractor::LookInSpace::Depth;
}

// The picture as this kind of file, with the bits that it takes.
template <class Picture> void become(Picture& picture, const Target& target) {
    using enum io::PictureFormat::Depth;
    if (isDepth(picture) && target.file != io::PictureFile::Png)
        throw UsageError{tr("--look depth can be drawn only as .png, and “%1” is not.").arg(target.output)};
    picture.file = *target.file;
    picture.quality = target.quality;
    if (!isDepth(picture) && !io::takes(picture.file, picture.depth)) {
        if (isSolid(picture))
            throw UsageError{tr("The bands of this solid were drawn with %1 bits per channel, which “%2” "
                                "cannot hold.")
                                 .arg(picture.depth == Bits8 ? 8 : 16)
                                 .arg(target.output)};
        picture.depth = picture.depth == Bits8 ? Bits16 : Bits8;
    }
    if (const io::Failure reason = io::whyImpossible(picture)) throw UsageError{*reason};
}

// Writes the sums or the picture, as the name of the output asks for.
template <class Sums>
ExitStatus write(Sums sums, const Target& target, const Verbosity& verbosity, const Interrupt& interrupt) {
    const bool isSum = !target.file;
    if (!isSum) {
        become(sums.picture, target);
        if (const io::Failure missing = io::incompleteness(sums))
            throw InputError{QStringLiteral("barycage-cli"), *missing};
    }
    ProgressBar bar(applied(verbosity));
    const auto progress = [&](double fraction) { bar.show(fraction); };
    const QString path = isStandardOutput(target.output) ? io::standardOutputPath() : target.output;
    const io::ExportOutcome outcome = isSum ? io::exportSums(sums, path, progress, interrupt.token())
                                            : io::exportPicture(sums, path, progress, interrupt.token());
    bar.clear();
    if (outcome.stopped) {
        reportError(QStringLiteral("barycage-cli"),
                    interrupt.isOutOfTime() ? tr("The time limit has passed; nothing was written.")
                                            : tr("Interrupted; nothing was written."));
        return interrupt.status();
    }
    if (!outcome.failure) return ExitStatus::Done;
    reportError(target.output, *outcome.failure);
    return ExitStatus::CannotReadOrWrite;
}

int threadsOf(const std::optional<std::string>& text) {
    return text ? integerArgument("--threads", *text, 1, 1024) : io::threadsOfThisMachine();
}

bool isSumFile(const QString& output) {
    return QFileInfo(output).suffix().compare(u"sum", Qt::CaseInsensitive) == 0;
}

using AnySums = std::variant<io::PictureSums, io::SpaceSums>;

template <class Loaded> AnySums loadedSums(const Loaded& loaded) {
    if (loaded.failure) throw InputError{QStringLiteral("barycage-cli"), *loaded.failure};
    return loaded.sums;
}

// Throws InputError where the files are no parts of one picture.
AnySums readSums(const QStringList& paths, int threads) {
    const QString program = QStringLiteral("barycage-cli");
    const auto files = std::make_shared<io::SumFiles>(paths);
    if (files->failure())
        throw InputError{program, *files->failure(),
                         files->isUnreadable() ? ExitStatus::CannotReadOrWrite : ExitStatus::InputProblems};
    return io::areOfSpace(*files) ? loadedSums(io::spaceSumsIn(files, threads))
                                  : loadedSums(io::sumsIn(files, threads));
}

struct MergeArguments {
    std::vector<std::string> files;
    std::string output;
    std::optional<std::string> threads, quality;
    Verbosity verbosity;
};

ExitStatus merge(const MergeArguments& arguments) {
    const QString output = fileNameOf(arguments.output);
    const std::optional<io::PictureFile> kind = io::pictureFileOf(QFileInfo(output).suffix());
    if (!kind && !isSumFile(output))
        throw UsageError{tr("The parts can be merged into a .png, .jpg, .webp, .tiff, .exr or .sum file, and "
                            "“%1” is none of them.")
                             .arg(output)};
    const std::optional<int> quality = qualityArgument(arguments.quality, kind);
    QStringList files;
    for (const std::string& file : arguments.files)
        files << fileNameOf(file);
    const AnySums read = readSums(files, threadsOf(arguments.threads));
    return std::visit(
        [&](const auto& sums) {
            return write(sums, {output, kind, quality}, arguments.verbosity, Interrupt());
        },
        read);
}

int heightOf(const io::PictureSums& sums) {
    return sums.picture.request.camera.height;
}
int heightOf(const io::SpaceSums& sums) {
    return sums.picture.request.camera.size.height;
}

template <class Sums>
ExitStatus resume(Sums sums, const RenderArguments& arguments, const Interrupt& interrupt) {
    const QString output = fileNameOf(arguments.output);
    refuseIf(isSolid(sums.picture), "--resume", tr("a solid is not made of samples."));
    const std::uint64_t points = countArgument("--points", *arguments.points, 1, maxPoints);
    const std::uint64_t there = std::accumulate(sums.passes.begin(), sums.passes.end(), std::uint64_t{0});
    if (points <= there)
        throw UsageError{tr("--points must be larger than %2, which “%1” already has.")
                             .arg(fileNameOf(*arguments.resume), QString::number(there))};
    addPass(sums, points - there);
    if (isDivided(arguments)) {
        const Rows rows = bandArgument(arguments, heightOf(sums));
        sums.drawn = {{rows.first, rows.end, sums.passes.size() - 1, partArgument(arguments)}};
        sums.files.reset();
    }
    Target target{output, {}, qualityOf(arguments)};
    if (!isSumFile(output)) target.file = pictureFileOf(arguments);
    return write(sums, target, arguments.verbosity, interrupt);
}

} // namespace

void checkParts(const RenderArguments& arguments, Format format) {
    if (arguments.part) partArgument(arguments);
    if (arguments.band) shareArgument("--band", *arguments.band);
    if (arguments.resume) {
        refuseWhatIsDecided(arguments);
        if (!arguments.points)
            throw UsageError{tr("--resume needs --points, the number of points of the whole picture.")};
        refuseIf(format != Format::Pixels && format != Format::Sum, "--resume",
                 tr("it writes pictures made of pixels, or .sum files."));
    } else if (arguments.files.empty()) {
        throw UsageError{tr("FILE is missing. Usage: barycage-cli %1")
                             .arg(QStringLiteral("render FILE... -o OUT [OPTION]..."))};
    }
    if (isDivided(arguments) && format != Format::Sum)
        throw UsageError{
            tr("A part of a picture is written to a .sum file, which barycage-cli merge reads.")};
    refuseIf(format == Format::Sum && arguments.frame, "--frame", tr("a .sum file shows the entry at rest."));
    const QString reason = tr("it applies only to --algorithm density.");
    refuseIf(format == Format::Sum && arguments.algorithm != "density", "--algorithm", reason);
}

io::PictureSums partOfPicture(const io::PngExport& picture, const RenderArguments& arguments) {
    const Rows rows = bandArgument(arguments, picture.request.camera.height);
    return io::partOf(picture, rows.first, rows.end, partArgument(arguments));
}

io::SpaceSums partOfPicture(const io::SpaceExport& picture, const RenderArguments& arguments) {
    refuseIf(arguments.part && isSolid(picture), "--part",
             tr("a solid is not made of samples; divide it with --band."));
    refuseIf(picture.stereo != io::Stereo::None, "--stereo", tr("a .sum file holds what one eye sees."));
    const Rows rows = bandArgument(arguments, picture.request.camera.size.height);
    return io::partOf(picture, rows.first, rows.end, partArgument(arguments));
}

ExitStatus resumePicture(const RenderArguments& arguments) {
    const Interrupt interrupt(timeLimitOf(arguments));
    const AnySums read = readSums({fileNameOf(*arguments.resume)}, threadsOf(arguments.threads));
    return std::visit([&](const auto& sums) { return resume(sums, arguments, interrupt); }, read);
}

Command mergeCommand() {
    auto arguments = std::make_shared<MergeArguments>();
    Command command("merge", "Merge the parts of a picture", "merge FILE... -o OUT [OPTION]...");
    const OptionGroup files = command.group("Files");
    files.argument("FILE...", &arguments->files, "Parts of one picture, written by render or merge")
        .required();
    files
        .add("-o,--output", "OUT", &arguments->output,
             "Picture to write once all parts are present, in a format of render, or their sum (.sum)")
        .fileName()
        .required();
    files.add("--quality", "Q", &arguments->quality, "Quality of .jpg and .webp, 1 to 100",
              "92; WebP without loss");
    command.group("Algorithm")
        .add("-j,--threads", "N", &arguments->threads, "Threads, 1 to 1024; never changes the picture",
             "all cores");
    addVerbosityOptions(command, arguments->verbosity);
    command.run = [arguments] { return merge(*arguments); };
    return command;
}

} // namespace cli
