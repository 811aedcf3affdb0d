// SPDX-License-Identifier: MIT
#include "options/commands.h"
#include "options/tr.h"
#include "options/usage_error.h"
#include "process/files_read.h"
#include "process/input.h"
#include "process/interrupt.h"
#include "process/messages.h"
#include "process/output.h"
#include "process/progress_bar.h"
#include "render/render_arguments.h"

#include "collage/suggestions.h"
#include "io/fractint/entry_writer.h"
#include "io/picture/decoding/grey_picture.h"
#include "io/picture/plane_export.h"
#include "io/report/json_writer.h"

#include <QDir>
#include <QFileInfo>

#include <memory>
#include <optional>

namespace cli {

namespace {

struct MapCounts {
    int least = 2, most = 8;
};

struct CollageArguments {
    std::string picture;
    std::string output;
    std::optional<std::string> report;
    MapCounts maps;
    std::optional<std::chrono::duration<double>> seconds;
    std::optional<std::uint64_t> starts;
    std::uint64_t seed = 1;
    bool similarities = false;
    bool withoutMirrors = false;
    std::optional<int> angles; // degrees
    bool stem = false;
    std::optional<int> threshold;
    bool invert = false;
    std::optional<int> threads;
    Verbosity verbosity;
};

constexpr int minMaps = 2, maxMaps = 16;

// "4", or "2-8".
MapCounts mapsArgument(const std::string&, const std::string& text) {
    const QStringList parts = QString::fromStdString(text).split(u'-');
    bool areNumbers = parts.size() <= 2;
    for (const QString& part : parts) {
        bool isNumber = false;
        const int maps = part.toInt(&isNumber);
        areNumbers = areNumbers && isNumber && maps >= minMaps && maps <= maxMaps;
    }
    const MapCounts counts{parts.front().toInt(), parts.back().toInt()};
    if (!areNumbers || counts.least > counts.most)
        throw UsageError{tr("--maps “%1” is not valid: it must be a number from 2 to 16, or a range such as "
                            "2-8.")
                             .arg(QString::fromStdString(text))};
    return counts;
}

int angleArgument(const std::string&, const std::string& text) {
    if (text == "60" || text == "90") return std::stoi(text);
    throw UsageError{
        tr("--angles “%1” is not valid: it must be 60 or 90 degrees.").arg(QString::fromStdString(text))};
}

collage::Constraints constraintsOf(const CollageArguments& arguments) {
    collage::Constraints constraints;
    if (arguments.similarities) constraints.mapClass = collage::MapClass::Similarity;
    if (arguments.withoutMirrors) constraints.mirrors = collage::Mirrors::Excluded;
    if (arguments.stem) constraints.first = collage::FirstMap::Stem;
    if (arguments.angles) constraints.angleStep = *arguments.angles;
    return constraints;
}

collage::SearchOptions optionsOf(const CollageArguments& arguments) {
    collage::SearchOptions options;
    options.minMaps = arguments.maps.least;
    options.maxMaps = arguments.maps.most;
    if (arguments.seconds) options.time = *arguments.seconds;
    if (arguments.starts) options.starts = std::size_t(*arguments.starts);
    options.seed = arguments.seed;
    options.constraints = constraintsOf(arguments);
    options.threads = threadsOf(arguments.threads);
    options.maxResults = 4;
    return options;
}

void checkOutputs(const CollageArguments& arguments) {
    const QString output = fileNameOf(arguments.output), picture = fileNameOf(arguments.picture);
    if (!isStandardOutput(output) && QFileInfo(output).suffix().toLower() != QStringLiteral("ifs"))
        throw UsageError{tr("The output must be an .ifs file, and “%1” is not.").arg(output)};
    noteRead(picture);
    refuseToReplaceInput(output);
    if (!arguments.report) return;
    const QString report = fileNameOf(*arguments.report);
    refuseToReplaceInput(report);
    const auto place = [](const QString& path) {
        return QDir::cleanPath(QFileInfo(path).absoluteFilePath());
    };
    if (place(report) == place(output) || (!isStandardOutput(report) && isSameFile(report, output)))
        throw UsageError{tr("--report “%1” names the output. Write to another file.").arg(report)};
}

// Empty when stopped. Throws InputError where there is nothing to trace.
collage::Mask targetOf(const CollageArguments& arguments, const std::stop_token& stop) {
    const QString name = fileNameOf(arguments.picture);
    const std::optional<int>& threshold = arguments.threshold;
    const io::Loaded loaded = loadBytes(arguments.picture);
    if (loaded.failure) throw InputError{name, *loaded.failure, ExitStatus::CannotReadOrWrite};
    const io::LoadedGrey grey = io::readGreyPicture(loaded.bytes, stop);
    if (stop.stop_requested()) return {};
    if (grey.flaw) throw InputError{name, *grey.flaw};
    if (grey.isReduced)
        reportWarning(name, tr("The picture is large; it is traced at %1 × %2 pixels.")
                                .arg(grey.picture.width)
                                .arg(grey.picture.height));
    const auto polarity = arguments.invert ? collage::Polarity::Background : collage::Polarity::Shape;
    collage::Mask mask = collage::targetMask(grey.picture, threshold, polarity);
    const std::size_t area = collage::area(mask);
    if (area == 0 || area == mask.cells.size())
        throw InputError{name, threshold ? tr("With this threshold, the shape is empty or fills the picture.")
                                         : tr("The picture has only one shade, so it contains no shape.")};
    return mask;
}

document::Fractal fractalOf(const collage::Suggestion& found, const QString& picture) {
    document::Fractal fractal;
    const QString name = QFileInfo(picture).completeBaseName();
    fractal.name = picture == u"-" || name.isEmpty() ? QStringLiteral("collage") : name;
    document::Shape<2> shape;
    for (std::size_t i = 0; i < found.maps.size(); ++i)
        ifs::append<2>(shape.system, found.maps[i], found.weights[i]);
    fractal.shape = std::move(shape);
    return fractal;
}

QByteArray reportOf(const collage::Mask& mask, const collage::Suggestion& found, std::size_t starts) {
    io::JsonWriter json;
    json.beginObject(io::JsonWriter::Layout::Inline);
    json.key("size");
    json.beginArray(io::JsonWriter::Layout::Inline);
    json.value(mask.width);
    json.value(mask.height);
    json.endArray();
    json.member("mean", found.attractor.mean);
    json.member("p95", found.attractor.p95);
    json.member("hausdorff", found.collage.images.hausdorff);
    json.member("iou", found.attractor.iou);
    json.member("overlap", found.collage.overlap);
    json.member("bound", found.collage.bound);
    json.member("starts", double(starts));
    json.endObject();
    return json.text();
}

ExitStatus collageOf(const CollageArguments& arguments) {
    const ProgressMode mode = applied(arguments.verbosity);
    const collage::SearchOptions options = optionsOf(arguments);
    checkOutputs(arguments);
    const Interrupt interrupt;
    const collage::Mask mask = targetOf(arguments, interrupt.token());
    ProgressBar bar(mode);
    collage::Suggestions found;
    if (!interrupt.token().stop_requested())
        found = collage::suggestions(
            mask, options, [&](double share) { bar.show(share); }, interrupt.token());
    bar.clear();
    if (interrupt.token().stop_requested()) {
        reportError(QStringLiteral("barycage-cli"), tr("Interrupted; nothing was written."));
        return interrupt.status();
    }
    if (found.list.empty()) throw InputError{fileNameOf(arguments.picture), tr("No system was found.")};
    const collage::Suggestion& best = found.list.front();
    const ExitStatus status = writeOutput(fileNameOf(arguments.output),
                                          io::writeEntry(fractalOf(best, fileNameOf(arguments.picture))));
    if (status != ExitStatus::Done || !arguments.report) return status;
    return writeOutput(fileNameOf(*arguments.report), reportOf(mask, best, found.starts));
}

void addSearchOptions(Command& command, CollageArguments& arguments) {
    const OptionGroup search = command.group("Search");
    search.add(
        "--maps", "N|MIN-MAX", parsed(&arguments.maps, mapsArgument),
        "Number of maps, 2 to 16, or a range, in which a map is added only if it improves the fit enough",
        "2-8");
    search.add("--seconds", "S", parsed(&arguments.seconds, secondsArgument), "How long to search", "2")
        .excludes("--starts");
    search.add("--starts", "K", parsed(&arguments.starts, countFrom(1, 1'000'000'000)),
               "Number of random starts, instead of a time; the result is then the same on every run");
    search.add("--seed", "K", parsed(&arguments.seed, wholeArgument), "Seed of the random starts", "1");
    search.flag("--similarities", &arguments.similarities, "Only maps that keep all angles");
    search.flag("--no-mirrors", &arguments.withoutMirrors, "No maps that reflect");
    search
        .add("--angles", "60|90", parsed(&arguments.angles, angleArgument),
             "Maps rotate only by multiples of this many degrees", "any")
        .moreOf("The rotation of a map is that of its polar decomposition.")
        .completedBy(Completion::Kind::Words, {"60", "90"});
    search
        .flag("--stem", &arguments.stem,
              "The first map flattens the shape to a line, like the stem of a fern")
        .moreOf("It is free of the other constraints.");
    addThreadsOption(search, arguments.threads).description =
        "Threads, 1 to 1024; never changes the result of --starts";
}

} // namespace

Command collageCommand() {
    auto arguments = std::make_shared<CollageArguments>();
    Command command("collage", "Find a system whose attractor looks like a picture",
                    "collage PICTURE -o OUT.ifs [OPTION]...");
    command.more = "The shape consists of the opaque pixels if the picture has transparent ones, "
                   "otherwise of the dark pixels. In the system, the height of the picture is 1, y is "
                   "up, and the middle of the picture is the origin.";
    const OptionGroup files = command.group("Files");
    files
        .argument("PICTURE", &arguments->picture,
                  "PNG, JPEG, WebP, TIFF, OpenEXR, GIF, BMP or PNM; - for standard input")
        .required();
    files.add("-o,--output", "OUT.ifs", &arguments->output, "File to write; - for standard output")
        .completedBy(Completion::Kind::Files, {"ifs"})
        .fileName()
        .required();
    files.add("--report", "R.json", &arguments->report, "Write how well it fits, in pixels of the picture")
        .moreOf("mean, p95 and iou compare the shape with the attractor, hausdorff with its collage; "
                "overlap is the area of all images of the shape together, divided by the area that "
                "they cover; no point of the shape or the attractor is farther from the other than "
                "bound; starts is the number of random starts.")
        .completedBy(Completion::Kind::Files, {"json"});
    const OptionGroup shape = command.group("Shape");
    shape
        .add("--threshold", "T", parsed(&arguments->threshold, integerFrom(0, 255)),
             "Grey level from 0 to 255 up to which a pixel is dark and belongs to the shape", "Otsu's")
        .moreOf("Of a picture with transparent pixels, 255 minus the opacity counts instead of the "
                "grey level, and the threshold is 127 by default.");
    shape.flag("--invert", &arguments->invert, "Trace the light or transparent part instead");
    addSearchOptions(command, *arguments);
    addVerbosityOptions(command, arguments->verbosity);
    command.run = [arguments] { return collageOf(*arguments); };
    return command;
}

} // namespace cli
