// SPDX-License-Identifier: MIT
#include "arguments.h"
#include "commands.h"
#include "input.h"
#include "interrupt.h"
#include "messages.h"
#include "output.h"
#include "progress_bar.h"
#include "render_view.h"
#include "usage_error.h"

#include "attractor/kernels.h"
#include "ifs/hull_cage.h"
#include "ifs/support_function.h"
#include "io/export_job.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <limits>
#include <memory>

namespace cli {

namespace {

using Text = std::optional<std::string>;

struct Arguments {
    std::string file;
    std::string output;
    std::string entry;
    std::string format;
    std::string size = "1200x900";
    std::string seed = "1";
    Text points, margin, cage, restCage, view, palette, colour, gamma, brightness, background, dpi, simd, svg;
    std::string algorithm = "density";
    std::optional<int> iterations, supersample, threads, depth, bits;
    bool yDown = false;
    std::string progress = "auto";
};

QString tr(const char* text) {
    return QCoreApplication::translate("cli", text);
}

enum class Format { Png, Svg, Pdf };

Format formatOf(const Arguments& arguments) {
    const QString suffix = arguments.format.empty()
                               ? QFileInfo(QString::fromStdString(arguments.output)).suffix().toLower()
                               : QString::fromStdString(arguments.format);
    if (suffix == u"png") return Format::Png;
    if (suffix == u"svg") return Format::Svg;
    if (suffix == u"pdf") return Format::Pdf;
    if (isStandardOutput(QString::fromStdString(arguments.output)))
        throw UsageError{tr("Say with --to what is written to standard output: png, svg or pdf.")};
    throw UsageError{tr("The picture is written as .png, .svg or .pdf, and “%1” is none of them.")
                         .arg(QString::fromStdString(arguments.output))};
}

io::ShapeStyle styleOf(const Arguments& arguments) {
    const std::string style = arguments.svg.value_or("structured");
    return style == "outline"  ? io::ShapeStyle::Outline
           : style == "points" ? io::ShapeStyle::Points
                               : io::ShapeStyle::Structured;
}

io::SvgFormat shapesOf(const Arguments& arguments) {
    io::SvgFormat format;
    format.depth = arguments.depth;
    format.style = styleOf(arguments);
    format.seed = wholeArgument("--seed", arguments.seed);
    if (arguments.points) format.points = wholeArgument("--points", *arguments.points);
    if (format.points < 1 || format.points > io::SvgFormat::mostPoints)
        throw UsageError{
            tr("--points of a scalable picture takes a number from 1 to %1.").arg(io::SvgFormat::mostPoints)};
    return format;
}

void refuseIf(bool given, const char* option, const QString& reason) {
    if (given) throw UsageError{tr("%1 is not possible here: %2").arg(QLatin1String(option), reason)};
}

// What this version cannot do, and what makes no sense for the format. Nothing is ignored silently.
void refuseUnsupported(const Arguments& arguments, Format format) {
    if (format != Format::Png) {
        const QString reason = tr("a scalable picture is made of shapes.");
        refuseIf(arguments.points && styleOf(arguments) != io::ShapeStyle::Points, "--points",
                 tr("a scalable picture is made of copies; points are drawn with --svg points."));
        refuseIf(arguments.depth && styleOf(arguments) == io::ShapeStyle::Points, "--depth",
                 tr("points have no levels of copies."));
        refuseIf(arguments.algorithm != "density", "--algorithm", reason);
        refuseIf(arguments.iterations.has_value(), "--iterations", tr("a scalable picture takes --depth."));
        refuseIf(arguments.gamma.has_value(), "--gamma", reason);
        refuseIf(arguments.brightness.has_value(), "--brightness", reason);
        refuseIf(arguments.supersample.has_value(), "--supersample", reason);
        refuseIf(arguments.bits.has_value(), "--bits", reason);
        refuseIf(arguments.dpi.has_value(), "--dpi", tr("a scalable picture has no resolution."));
    } else {
        const QString reason = tr("it belongs to scalable pictures (.svg and .pdf).");
        refuseIf(arguments.svg.has_value(), "--svg", reason);
        refuseIf(arguments.depth.has_value(), "--depth", reason);
    }
    const bool deterministic = arguments.algorithm == "deterministic";
    refuseIf(arguments.iterations && !deterministic, "--iterations",
             tr("it belongs to --algorithm deterministic."));
    refuseIf(arguments.points && deterministic, "--points", tr("--algorithm deterministic has no points."));
}

attractor::ColourBy colourBy(const std::string& text) {
    if (text == "density") return attractor::ColourBy::Density;
    if (text == "map") return attractor::ColourBy::Map;
    if (text == "address") return attractor::ColourBy::Address;
    if (text == "none") return attractor::ColourBy::Plain;
    throw UsageError{
        tr("--colour takes density, map, address or none, and not “%1”.").arg(QString::fromStdString(text))};
}

attractor::Algorithm algorithmOf(const std::string& text) {
    if (text == "density") return attractor::Algorithm::Density;
    if (text == "chaos-game") return attractor::Algorithm::ChaosGame;
    if (text == "deterministic") return attractor::Algorithm::Deterministic;
    throw UsageError{tr("--algorithm takes density, chaos-game or deterministic, and not “%1”.")
                         .arg(QString::fromStdString(text))};
}

void selectInstructions(const std::string& name) {
    if (attractor::selectSimd(name)) return;
    QStringList here;
    for (const std::string& possible : attractor::simdNames())
        here << QString::fromStdString(possible);
    throw UsageError{tr("--simd “%1” is not possible here; this machine has %2.")
                         .arg(QString::fromStdString(name), here.join(QStringLiteral(", ")))};
}

bool isLight(const attractor::Rgba& colour) {
    return 0.299 * colour.red + 0.587 * colour.green + 0.114 * colour.blue > 128;
}

void applyAppearance(attractor::Appearance& appearance, const Arguments& arguments) {
    if (arguments.colour) appearance.colourBy = colourBy(*arguments.colour);
    if (arguments.palette) appearance.palette = paletteArgument("--palette", *arguments.palette);
    if (arguments.gamma) appearance.gamma = positiveArgument("--gamma", *arguments.gamma);
    if (arguments.brightness) appearance.brightness = positiveArgument("--brightness", *arguments.brightness);
    if (arguments.background) {
        appearance.background = colourArgument("--background", *arguments.background);
        const bool paper = isLight(appearance.background) && appearance.background.alpha == 255;
        if (paper && isLight(appearance.plain)) appearance.plain = {20, 20, 20, 255}; // it must be seen
    }
    if (arguments.supersample) appearance.supersample = *arguments.supersample;
}

// N of "hull:N".
int hullCorners(const std::string& text) {
    constexpr int Usual = 8;
    if (text == "hull") return Usual;
    bool isNumber = false;
    const int corners = QString::fromStdString(text.substr(5)).toInt(&isNumber);
    if (!isNumber || corners < 3 || corners > 64)
        throw UsageError{tr("--rest-cage hull:N takes 3 to 64 corners, and not “%1”.")
                             .arg(QString::fromStdString(text.substr(5)))};
    return corners;
}

// A certified box or hull around the attractor.
std::vector<ifs::Vector<2>> verticesAround(const document::Fractal& fractal, const std::string& text) {
    const auto maps = ifs::activeMaps(*document::system2(fractal)).maps;
    const auto support = ifs::SupportFunction<2>::of(maps);
    if (!support)
        throw UsageError{tr("--rest-cage %1 is not possible here: the system has no certified attractor.")
                             .arg(QString::fromStdString(text))};
    const auto box = ifs::boundingBox(*support);
    if (text == "box") {
        const ifs::Vector<2> min = box.min.array() - box.error, max = box.max.array() + box.error;
        return {min, {max.x(), min.y()}, max, {min.x(), max.y()}};
    }
    const auto hull = ifs::convexHull(*support, 1e-6 * (box.max - box.min).norm());
    return ifs::simplifiedHull(ifs::enlargedHull(hull.vertices, hull.error), hullCorners(text));
}

// The rest vertices that --rest-cage and the entry ask for.
std::vector<ifs::Vector<2>> restVertices(const document::Fractal& fractal, const Arguments& arguments) {
    if (!arguments.restCage) return document::effectiveCage(fractal).rest;
    const std::string& text = *arguments.restCage;
    if (text == "canonical") {
        document::Fractal bare = fractal;
        bare.cage.reset();
        return document::effectiveCage(bare).rest;
    }
    if (text == "box" || text == "hull" || text.starts_with("hull:")) return verticesAround(fractal, text);
    return pointsArgument("--rest-cage", text);
}

void applyCage(document::Fractal& fractal, const Arguments& arguments) {
    if (!arguments.cage && !arguments.restCage) return;
    ifs::ControlCage<2> cage;
    cage.rest = restVertices(fractal, arguments);
    cage.current = arguments.cage ? pointsArgument("--cage", *arguments.cage) : cage.rest;
    if (cage.current.size() != cage.rest.size())
        throw UsageError{tr("The cage has %1 corners and the rest cage %2: they must have the same number.")
                             .arg(cage.current.size())
                             .arg(cage.rest.size())};
    if (!ifs::isValid(cage))
        throw UsageError{
            cage.rest.size() == 3
                ? tr("The corners of the rest cage lie on one line, so they hold no coordinates.")
                : tr("The rest cage must be a polygon of 3 to 64 corners that does not cross "
                     "itself.")};
    fractal.cage = cage;
}

attractor::Camera cameraOf(const document::Fractal& fractal, const Arguments& arguments,
                           const QString& fileName) {
    attractor::Camera camera;
    const QSize size = sizeArgument("--size", arguments.size);
    camera.width = size.width();
    camera.height = size.height();
    camera.yAxis = arguments.yDown ? attractor::YAxis::Down : attractor::YAxis::Up;
    if (arguments.view) {
        refuseIf(arguments.margin.has_value(), "--margin", tr("--view already says what is seen."));
        const View view = viewArgument("--view", *arguments.view);
        camera.centre = view.centre;
        camera.pixelsPerUnit = camera.height / view.height;
        return camera;
    }
    const double margin = arguments.margin ? marginArgument("--margin", *arguments.margin) : 0.05;
    const bool deterministic = arguments.algorithm == "deterministic";
    const ViewBox box =
        deterministic ? boxOfIterate(fractal, *arguments.iterations) : boxOfAttractor(fractal);
    if (!box.certified)
        reportWarning(fileName,
                      tr("No box around the picture could be certified; it is framed by where points go. "
                         "Give the frame with --view."));
    return fitted(camera, box.min, box.max, margin);
}

attractor::RenderRequest requestOf(const document::Fractal& fractal, const attractor::Camera& camera,
                                   const Arguments& arguments) {
    attractor::RenderRequest request = document::renderRequest(fractal, camera);
    const auto pixels = std::uint64_t(camera.width) * std::uint64_t(camera.height);
    request.algorithm = algorithmOf(arguments.algorithm);
    request.seed = wholeArgument("--seed", arguments.seed);
    request.threads = arguments.threads.value_or(io::threadsOfThisMachine());
    const std::uint64_t perPixel = request.algorithm == attractor::Algorithm::ChaosGame ? 2 : 100;
    request.samples = arguments.points ? wholeArgument("--points", *arguments.points)
                                       : std::max<std::uint64_t>(perPixel * pixels, 1'000'000);
    if (request.samples == 0) throw UsageError{tr("--points takes at least one point.")};
    if (request.algorithm == attractor::Algorithm::Deterministic) {
        request.iterations = *arguments.iterations;
        request.samples = 1;
        if (!request.cage) request.cage = document::effectiveCage(fractal);
    }
    return request;
}

void checkDepth(const document::Fractal& fractal, const attractor::Camera& camera,
                const Arguments& arguments) {
    if (!arguments.depth) return;
    const io::SvgPlan plan = io::svgPlan(fractal, camera, shapesOf(arguments));
    if (!plan.failure && plan.depth != *arguments.depth)
        throw UsageError{
            tr("--depth %1 would need 400,000 references or more; the deepest possible here is %2.")
                .arg(*arguments.depth)
                .arg(plan.deepest)};
}

io::Export exportOf(const document::Fractal& fractal, const attractor::Camera& camera, Format format,
                    const Arguments& arguments) {
    if (format != Format::Png) {
        checkDepth(fractal, camera, arguments);
        const auto file = format == Format::Pdf ? io::ShapeFile::Pdf : io::ShapeFile::Svg;
        return io::SvgExport{fractal, camera, shapesOf(arguments), file};
    }
    io::PngExport picture{fractal, requestOf(fractal, camera, arguments), {}};
    if (arguments.bits == 16) picture.depth = io::PngFormat::Depth::Bits16;
    if (arguments.dpi) {
        picture.dotsPerInch = positiveArgument("--dpi", *arguments.dpi);
        constexpr double most = 100'000;
        if (picture.dotsPerInch < 1 || picture.dotsPerInch > most)
            throw UsageError{tr("--dpi takes a number from 1 to 100000.")};
    }
    return picture;
}

void reportNote(attractor::RenderNote note, const QString& fileName) {
    switch (note) {
    case attractor::RenderNote::None:
    case attractor::RenderNote::NoMaps:
        break;
    case attractor::RenderNote::NoAttractor:
        return reportWarning(fileName,
                             tr("The system has no attractor: some word of maps does not contract. What is "
                                "drawn is where points go before they escape."));
    case attractor::RenderNote::Undecided:
        return reportWarning(fileName, tr("Whether the system has an attractor could not be decided."));
    case attractor::RenderNote::TooDeep:
        return reportWarning(fileName, tr("The view is smaller than the arithmetic can resolve."));
    case attractor::RenderNote::FewerIterations:
        return reportWarning(fileName,
                             tr("So many iterations are more copies than can be drawn; fewer were made."));
    case attractor::RenderNote::Degenerate:
        return reportWarning(fileName, tr("The cage is flat, and so is the picture."));
    }
}

ExitStatus finish(const io::ExportOutcome& outcome, const QString& fileName, const QString& output) {
    if (outcome.stopped) {
        reportError(fileName, tr("Interrupted; nothing was written."));
        return ExitStatus::Interrupted;
    }
    if (outcome.failure) {
        reportError(output, *outcome.failure);
        return ExitStatus::CannotReadOrWrite;
    }
    reportNote(outcome.note, fileName);
    return ExitStatus::Done;
}

bool hasMaps(const document::Fractal& fractal, const QString& fileName) {
    if (!ifs::activeMaps(*document::system2(fractal)).maps.empty()) return true;
    reportError(fileName,
                tr("“%1” has no map that takes part, so there is nothing to draw.").arg(fractal.name));
    return false;
}

ExitStatus render(const Arguments& arguments) {
    const Format format = formatOf(arguments);
    refuseUnsupported(arguments, format);
    const ProgressMode progress = progressMode(arguments.progress);
    if (arguments.simd) selectInstructions(*arguments.simd);
    if (algorithmOf(arguments.algorithm) == attractor::Algorithm::Deterministic && !arguments.iterations)
        throw UsageError{tr("--algorithm deterministic needs --iterations.")};
    const Interrupt interrupt;
    const auto input = readInput(arguments.file);
    if (!input) return ExitStatus::CannotReadOrWrite;
    const ToDraw toDraw = entryToDraw(*input, arguments.entry);
    if (!toDraw.entry || !hasMaps(*toDraw.entry->fractal, input->name)) return ExitStatus::InputProblems;
    document::Fractal fractal = *toDraw.entry->fractal;
    applyAppearance(fractal.appearance, arguments);
    applyCage(fractal, arguments);
    const attractor::Camera camera = cameraOf(fractal, arguments, input->name);
    const io::Export what = exportOf(fractal, camera, format, arguments);
    if (const auto* svg = std::get_if<io::SvgExport>(&what)) {
        const io::SvgPlan plan = io::svgPlan(svg->fractal, svg->camera, svg->format);
        if (plan.failure) {
            reportError(input->name, *plan.failure);
            return ExitStatus::InputProblems;
        }
        if (plan.unbent)
            reportWarning(input->name,
                          tr("The cage bends the picture, which the copies of a scalable picture "
                             "cannot follow: the affine fit of the cage is written."));
    }
    const QString output = QString::fromStdString(arguments.output);
    ProgressBar bar(progress);
    const auto outcome = exportOutput(
        what, output, [&](double fraction) { bar.show(fraction); }, interrupt.token());
    bar.clear();
    return std::max(toDraw.status, finish(outcome, input->name, output));
}

void addPictureOptions(CLI::App& command, Arguments& arguments) {
    command.add_option("--palette", arguments.palette, "Palette by name or from a file");
    command.add_option("--colour", arguments.colour, "Colour by density, map, address or none");
    command.add_option("--gamma", arguments.gamma, "Gamma of the tone curve (2.2)");
    command.add_option("--brightness", arguments.brightness, "Brightness of the tone curve (20)");
    command.add_option("--background", arguments.background,
                       "Colour like #0d1017, #0d101780 (the last two: opacity) or white, or transparent");
    command.add_option("--supersample", arguments.supersample, "Cells along the side of a pixel (1 to 4)")
        ->check(CLI::Range(1, 4));
    command.add_option("--bits", arguments.bits, "Bits a channel, PNG (8)")->check(CLI::IsMember({8, 16}));
    command.add_option("--dpi", arguments.dpi, "Resolution noted in the PNG, dots per inch");
    command
        .add_option("--svg", arguments.svg,
                    "Kind of scalable picture: structured, outline or points (structured)")
        ->check(CLI::IsMember({"structured", "outline", "points"}));
    command
        .add_option("--depth", arguments.depth, "Levels of copies in a scalable picture (what a pixel needs)")
        ->check(CLI::Range(0, std::numeric_limits<int>::max()));
}

void addAlgorithmOptions(CLI::App& command, Arguments& arguments) {
    command.add_option("--algorithm", arguments.algorithm, "density, chaos-game or deterministic")
        ->check(CLI::IsMember({"density", "chaos-game", "deterministic"}));
    command.add_option("--points", arguments.points,
                       "Samples (density), or points plotted (chaos-game, --svg points)");
    command.add_option("--iterations", arguments.iterations, "n of Wⁿ, for deterministic")
        ->check(CLI::Range(0, std::numeric_limits<int>::max()));
    command.add_option("--seed", arguments.seed, "Seed of the random numbers (1)");
    command.add_option("--threads", arguments.threads, "Threads; never changes the picture")
        ->check(CLI::Range(1, 1024));
    command.add_option("--simd", arguments.simd,
                       "Instruction set: scalar, sse4, avx2, avx3 or neon; never changes the picture");
}

void addFramingOptions(CLI::App& command, Arguments& arguments) {
    command.add_option("--size", arguments.size, "Width and height in pixels (1200x900)");
    command.add_option("--margin", arguments.margin, "Margin around the picture in per cent (5)");
    command.add_option("--view", arguments.view, "What is seen: \"cx,cy,height\"");
    command.add_flag("--y-down", arguments.yDown, "The y axis points down");
    command.add_option("--cage", arguments.cage,
                       "Where the corners are: \"x,y x,y x,y\", up to 64; more than three bend the picture");
    command.add_option("--rest-cage", arguments.restCage,
                       "Where they were: \"x,y x,y x,y\", canonical, box, hull or hull:N");
}

} // namespace

void addRenderCommand(CLI::App& program, Run& run) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App* command = program.add_subcommand("render", "Draw an entry as PNG, SVG or PDF");
    command
        ->add_option("FILE", arguments->file,
                     "Collection, or picture with a system inside; - for standard input")
        ->required();
    command
        ->add_option("-o,--output", arguments->output,
                     "Picture to write: .png, .svg or .pdf; - for standard output")
        ->required();
    command
        ->add_option("--to", arguments->format, "png, svg or pdf, where the name of the output does not tell")
        ->check(CLI::IsMember({"png", "svg", "pdf"}));
    command->add_option("--entry", arguments->entry,
                        "Entry to draw (the first in the plane that can be read)");
    addFramingOptions(*command, *arguments);
    addAlgorithmOptions(*command, *arguments);
    addPictureOptions(*command, *arguments);
    command->add_option("--progress", arguments->progress, "always, never or auto");
    command->callback([arguments, &run] { run = [arguments] { return render(*arguments); }; });
}

} // namespace cli
