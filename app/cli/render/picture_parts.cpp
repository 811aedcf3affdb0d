// SPDX-License-Identifier: MIT
#include "render/picture_parts.h"

#include "options/commands.h"
#include "options/tr.h"
#include "options/usage_error.h"
#include "process/files_read.h"
#include "process/input.h"
#include "process/interrupt.h"
#include "process/messages.h"
#include "process/output.h"
#include "process/output_names.h"
#include "process/picture_suffixes.h"
#include "process/progress_bar.h"

#include "io/file/standard_output.h"
#include "io/picture/picture_writers.h"

#include <QFileInfo>

#include <memory>
#include <numeric>
#include <variant>

namespace cli {

namespace {

attractor::PicturePart partOf(const RenderArguments& arguments) {
    const Share share = arguments.part.value_or(Share());
    return {std::uint64_t(share.index), std::uint64_t(share.count)};
}

// Rows of pixels.
struct PixelRows {
    int first = 0;
    int end = 0;
};
PixelRows bandOf(const RenderArguments& arguments, int height) {
    const Share share = arguments.band.value_or(Share());
    const auto boundary = [&](int number) { return int(std::int64_t(height) * number / share.count); };
    const PixelRows rows{boundary(share.index), boundary(share.index + 1)};
    if (rows.first == rows.end)
        throw UsageError{tr("--band %1 has no rows: the height of the picture is %2.")
                             .arg(QStringLiteral("%1/%2").arg(share.index).arg(share.count))
                             .arg(height)};
    return rows;
}

bool isDivided(const RenderArguments& arguments) {
    return arguments.part || arguments.band;
}

// The output of the sums or the picture.
struct Target {
    QString output;
    std::optional<io::PictureFile> file; // nullopt: sums
    std::optional<int> quality;
};

bool isSolid(const io::PlaneExport&) {
    return false;
}
bool isSolid(const io::SpaceExport& picture) {
    return !attractor::showsCloud(picture.look);
}
bool isDepth(const io::PlaneExport&) {
    return false;
}
bool isDepth(const io::SpaceExport& picture) {
    return picture.look == attractor::LookInSpace::Depth;
}

// Sets the kind of file, with the bits that it takes.
template <class Picture> void applyTarget(Picture& picture, const Target& target) {
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
        refuseToReplaceInput(target.output);
        applyTarget(sums.picture, target);
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

bool isSumFile(const QString& output) {
    return QFileInfo(output).suffix().compare(u"sum", Qt::CaseInsensitive) == 0;
}

using AnySums = std::variant<io::PictureSums, io::SpaceSums>;

ExitStatus statusOf(const io::SumFiles& files) {
    return files.isUnreadable() ? ExitStatus::CannotReadOrWrite : ExitStatus::InputProblems;
}

template <class Loaded> AnySums loadedSums(const Loaded& loaded, const io::SumFiles& files) {
    if (loaded.failure) throw InputError{QStringLiteral("barycage-cli"), *loaded.failure, statusOf(files)};
    return loaded.sums;
}

// Throws InputError where the files are no parts of one picture.
AnySums readSums(const QStringList& paths, int threads) {
    const QString program = QStringLiteral("barycage-cli");
    for (const QString& path : paths)
        noteRead(path);
    const auto files = std::make_shared<io::SumFiles>(paths);
    if (files->failure()) throw InputError{program, *files->failure(), statusOf(*files)};
    return io::areOfSpace(*files) ? loadedSums(io::spaceSumsIn(files, threads), *files)
                                  : loadedSums(io::sumsIn(files, threads), *files);
}

struct MergeArguments {
    std::vector<std::string> files;
    std::string output;
    std::optional<int> threads, quality;
    Verbosity verbosity;
};

ExitStatus merge(const MergeArguments& arguments) {
    const QString output = fileNameOf(arguments.output);
    const std::optional<io::PictureFile> kind = io::pictureFileOf(QFileInfo(output).suffix());
    if (!kind && !isSumFile(output))
        throw UsageError{tr("The parts can be merged into a %1 file, and “%2” is none of them.")
                             .arg(namedSuffixes(anyPicture, tr("or"), {"sum"}), output)};
    const std::optional<int> quality = fittingQuality(arguments.quality, kind);
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
    const std::uint64_t points = *arguments.points;
    const std::uint64_t there = std::accumulate(sums.passes.begin(), sums.passes.end(), std::uint64_t{0});
    if (points <= there)
        throw UsageError{tr("--points must be larger than %2, which “%1” already has.")
                             .arg(fileNameOf(*arguments.resume), QString::number(there))};
    addPass(sums, points - there);
    if (isDivided(arguments)) {
        const PixelRows rows = bandOf(arguments, heightOf(sums));
        sums.drawn = {{rows.first, rows.end, sums.passes.size() - 1, partOf(arguments)}};
        sums.files.reset();
        refuseToReplaceInput(output); // the input holds more than the output will
    }
    Target target{output, {}, qualityOf(arguments)};
    if (!isSumFile(output)) target.file = pictureFileOf(arguments);
    return write(sums, target, arguments.verbosity, interrupt);
}

} // namespace

void checkParts(const RenderArguments& arguments, Format format) {
    if (arguments.resume) {
        arguments.given.refuse(Picture, tr("the file that --resume names already defines the picture."));
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
    refuseIf(format == Format::Sum && arguments.algorithm != attractor::Algorithm::Density, "--algorithm",
             reason);
}

io::PictureSums partOfPicture(const io::PlaneExport& picture, const RenderArguments& arguments) {
    const PixelRows rows = bandOf(arguments, picture.request.camera.height);
    return io::partOf(picture, rows.first, rows.end, partOf(arguments));
}

io::SpaceSums partOfPicture(const io::SpaceExport& picture, const RenderArguments& arguments) {
    refuseIf(arguments.part && isSolid(picture), "--part",
             tr("a solid is not made of samples; divide it with --band."));
    refuseIf(picture.stereo != io::Stereo::None, "--stereo", tr("a .sum file holds what one eye sees."));
    const PixelRows rows = bandOf(arguments, picture.request.camera.size.height);
    return io::partOf(picture, rows.first, rows.end, partOf(arguments));
}

ExitStatus resumePicture(const RenderArguments& arguments) {
    const Interrupt interrupt(arguments.timeLimit);
    const AnySums read = readSums({fileNameOf(*arguments.resume)}, threadsOf(arguments.threads));
    return std::visit([&](const auto& sums) { return resume(sums, arguments, interrupt); }, read);
}

Command mergeCommand() {
    auto arguments = std::make_shared<MergeArguments>();
    Command command("merge", "Merge the parts of a picture", "merge FILE... -o OUT [OPTION]...");
    const OptionGroup files = command.group("Files");
    files.argument("FILE...", &arguments->files, "Parts of one picture, written by render or merge")
        .completedBy(Completion::Kind::Files, {"sum"})
        .required();
    files
        .add("-o,--output", "OUT", &arguments->output,
             "Picture to write once all parts are present, in a format of render, or their sum (.sum)")
        .completedBy(Completion::Kind::Files, pictureSuffixes(anyPicture, {"sum"}))
        .fileName()
        .required();
    addQualityOption(files, arguments->quality).standard = "92; WebP without loss";
    addThreadsOption(command.group("Algorithm"), arguments->threads);
    addVerbosityOptions(command, arguments->verbosity);
    command.run = [arguments] { return merge(*arguments); };
    return command;
}

} // namespace cli
