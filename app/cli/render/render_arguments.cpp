// SPDX-License-Identifier: MIT
#include "render/render_arguments.h"

#include "options/options.h"
#include "options/tr.h"
#include "options/usage_error.h"
#include "process/arguments.h"
#include "process/input.h"
#include "process/output.h"
#include "process/output_names.h"

#include "attractor/kernels/kernels.h"
#include "io/picture/picture_writers.h"
#include "io/text/number.h"

#include <QFileInfo>
#include <QStringList>

#include <algorithm>

namespace cli {

namespace {

// All steps in one picture.
bool isStrip(const RenderArguments& arguments) {
    return arguments.steps.first < arguments.steps.last && !hasIterations(fileNameOf(arguments.output));
}

Format formatOf(const RenderArguments& arguments) {
    if (!arguments.format.empty())
        choiceArgument("--to", arguments.format, {"png", "jpg", "webp", "tiff", "exr", "svg", "pdf"});
    const QString suffix = suffixOf(arguments);
    if (io::pictureFileOf(suffix)) return Format::Pixels;
    if (suffix == u"svg") return Format::Svg;
    if (suffix == u"pdf") return Format::Pdf;
    if (suffix == u"sum") return Format::Sum;
    if (isStandardOutput(fileNameOf(arguments.output)))
        throw UsageError{
            tr("Give the format for standard output with --to: png, jpg, webp, tiff, exr, svg or pdf.")};
    throw UsageError{
        tr("The picture can be written as .png, .jpg, .webp, .tiff, .exr, .svg, .pdf or .sum, and "
           "“%1” is none of them.")
            .arg(fileNameOf(arguments.output))};
}

io::ShapeStyle styleOf(const RenderArguments& arguments) {
    const std::string style =
        choiceArgument("--svg", arguments.svg.value_or("structured"), {"structured", "outline", "points"});
    return style == "outline"  ? io::ShapeStyle::Outline
           : style == "points" ? io::ShapeStyle::Points
                               : io::ShapeStyle::Structured;
}

// "6", or "0-6" for all from 0 to 6.
Steps stepsOf(const std::string& text) {
    constexpr int maxSteps = 1000;
    const std::size_t dash = text.find('-', 1);
    const auto number = [&](const std::string& part) {
        return integerArgument("--iterations", part, 0, maxInt);
    };
    if (dash == std::string::npos) return {number(text), number(text)};
    const Steps steps{number(text.substr(0, dash)), number(text.substr(dash + 1))};
    if (steps.last < steps.first || steps.last - steps.first >= maxSteps)
        throw UsageError{tr("--iterations “%1” is not valid: a range such as 0-6 must be ascending and have "
                            "at most %2 numbers.")
                             .arg(QString::fromStdString(text))
                             .arg(maxSteps)};
    return steps;
}

double vibrancyOf(const std::string& text) {
    const auto vibrancy = io::parseNumber(QString::fromStdString(text));
    if (vibrancy && *vibrancy >= 0 && *vibrancy <= 1) return *vibrancy;
    throw UsageError{tr("--vibrancy “%1” is not valid: it must be a number from 0 to 1.")
                         .arg(QString::fromStdString(text))};
}

} // namespace

QString suffixOf(const RenderArguments& arguments) {
    return arguments.format.empty() ? QFileInfo(fileNameOf(arguments.output)).suffix().toLower()
                                    : QString::fromStdString(arguments.format);
}

void selectInstructions(const std::string& name) {
    if (attractor::selectSimd(name)) return;
    QStringList here;
    for (const std::string& possible : attractor::simdNames())
        here << QString::fromStdString(possible);
    throw UsageError{tr("--simd “%1” is not available here; this machine has %2.")
                         .arg(QString::fromStdString(name), here.join(QStringLiteral(", ")))};
}

void refuseIf(bool given, const char* option, const QString& reason) {
    if (given) throw UsageError{tr("%1 cannot be used here: %2").arg(QLatin1String(option), reason)};
}

attractor::Algorithm algorithmOf(const std::string& text) {
    const std::string name = choiceArgument("--algorithm", text, {"density", "chaos-game", "deterministic"});
    return name == "density"      ? attractor::Algorithm::Density
           : name == "chaos-game" ? attractor::Algorithm::ChaosGame
                                  : attractor::Algorithm::Deterministic;
}

io::SvgFormat shapesOf(const RenderArguments& arguments) {
    io::SvgFormat format;
    if (arguments.depth) format.depth = integerArgument("--depth", *arguments.depth, 0, maxInt);
    format.style = styleOf(arguments);
    format.seed = wholeArgument("--seed", arguments.seed);
    if (arguments.points)
        format.points = countArgument("--points", *arguments.points, 1, io::SvgFormat::maxPoints);
    format.overlay = overlayOf(arguments);
    return format;
}

void applyAppearance(attractor::Appearance& appearance, const RenderArguments& arguments) {
    if (arguments.colour) appearance.colourBy = colourByArgument("--colour", *arguments.colour);
    if (arguments.readPalette) appearance.palette = *arguments.readPalette;
    if (arguments.gamma) appearance.gamma = positiveArgument("--gamma", *arguments.gamma);
    if (arguments.brightness) appearance.brightness = positiveArgument("--brightness", *arguments.brightness);
    if (arguments.contrast) appearance.contrast = positiveArgument("--contrast", *arguments.contrast);
    if (arguments.vibrancy) appearance.vibrancy = vibrancyOf(*arguments.vibrancy);
    if (arguments.background) {
        putOn(appearance, colourArgument("--background", *arguments.background));
    }
    if (arguments.supersample)
        appearance.supersample = integerArgument("--supersample", *arguments.supersample, 1, 4);
}

io::PictureFile pictureFileOf(const RenderArguments& arguments) {
    const io::PictureFile file = io::pictureFileOf(suffixOf(arguments)).value_or(io::PictureFile::Png);
    return file == io::PictureFile::ExrHalf && arguments.bits == "32" ? io::PictureFile::ExrFloat : file;
}

io::PictureFormat::Depth depthOf(const RenderArguments& arguments) {
    using enum io::PictureFormat::Depth;
    const bool isOnlyDeep = !io::takes(pictureFileOf(arguments), Bits8);
    return isOnlyDeep || is16Bit(arguments) ? Bits16 : Bits8;
}

bool is16Bit(const RenderArguments& arguments) {
    return arguments.bits && choiceArgument("--bits", *arguments.bits, {"8", "16", "32"}) == "16";
}

std::optional<int> qualityArgument(const std::optional<std::string>& quality,
                                   std::optional<io::PictureFile> file) {
    if (!quality) return std::nullopt;
    constexpr int maxQuality = 100;
    const bool hasQuality = file == io::PictureFile::Jpeg || file == io::PictureFile::WebP;
    const int number = integerArgument("--quality", *quality, 1, maxQuality);
    refuseIf(!hasQuality, "--quality", tr("it applies only to .jpg and .webp."));
    return number;
}

std::optional<int> qualityOf(const RenderArguments& arguments) {
    return qualityArgument(arguments.quality, pictureFileOf(arguments));
}

std::optional<double> dotsPerInch(const RenderArguments& arguments) {
    if (!arguments.dpi) return std::nullopt;
    constexpr double maxDots = 100'000;
    const auto dots = io::parseNumber(QString::fromStdString(*arguments.dpi));
    if (!dots || !(*dots >= 1 && *dots <= maxDots))
        throw UsageError{tr("--dpi “%1” is not valid: it must be a number from 1 to 100000.")
                             .arg(QString::fromStdString(*arguments.dpi))};
    return dots;
}

std::optional<std::chrono::duration<double>> timeLimitOf(const RenderArguments& arguments) {
    if (!arguments.timeLimit) return std::nullopt;
    return std::chrono::duration<double>(secondsArgument("--time-limit", *arguments.timeLimit));
}

std::optional<std::uint64_t> memoryLimitOf(const RenderArguments& arguments) {
    constexpr int minMegabytes = 64, maxMegabytes = 1'000'000;
    if (!arguments.memoryLimit) return std::nullopt;
    const int megabytes =
        integerArgument("--memory-limit", *arguments.memoryLimit, minMegabytes, maxMegabytes);
    return std::uint64_t(megabytes) << 20;
}

io::PictureOverlay overlayOf(const RenderArguments& arguments) {
    io::PictureOverlay overlay;
    if (!arguments.overlay) return overlay;
    const QStringList names = QString::fromStdString(*arguments.overlay).split(u',');
    for (const QString& name : names) {
        const std::string part = choiceArgument("--overlay", name.trimmed().toStdString(),
                                                {"maps", "hull", "cage", "fixed-points", "numbers"});
        if (part == "maps") overlay.maps = true;
        if (part == "hull") overlay.hull = true;
        if (part == "cage") overlay.cage = true;
        if (part == "fixed-points") overlay.fixedPoints = true;
        if (part == "numbers") overlay.numbers = true;
    }
    return overlay;
}

namespace {

// What each kind of file holds.
void checkPixels(const RenderArguments& arguments) {
    using enum io::PictureFormat::Depth;
    const io::PictureFile file = pictureFileOf(arguments);
    qualityOf(arguments);
    const std::string bits =
        arguments.bits ? choiceArgument("--bits", *arguments.bits, {"8", "16", "32"}) : "";
    if (!io::takes(file, Bits8))
        refuseIf(bits == "8", "--bits 8", tr("OpenEXR has 16 or 32 bits per channel."));
    else
        refuseIf(bits == "32", "--bits 32", tr("only .exr has 32 bits per channel."));
    refuseIf(bits == "16" && !io::takes(file, Bits16), "--bits 16",
             tr(".jpg and .webp have 8 bits per channel."));
}

// What makes no sense for the format, whatever the entry. Nothing is ignored silently.
void refuseUnsupported(const RenderArguments& arguments, Format format) {
    checkPixels(arguments);
    if (!isOfShapes(format)) {
        const QString reason = tr("it applies only to vector graphics (.svg and .pdf).");
        refuseIf(arguments.svg.has_value(), "--svg", reason);
        refuseIf(arguments.depth.has_value(), "--depth", reason);
    }
    const bool deterministic = arguments.algorithm == "deterministic";
    refuseIf(arguments.iterations && !deterministic, "--iterations",
             isOfShapes(format) ? tr("for vector graphics, use --depth.")
                                : tr("it applies only to --algorithm deterministic."));
    refuseIf(arguments.points && deterministic, "--points", tr("--algorithm deterministic has no points."));
}

} // namespace

bool isOfShapes(Format format) {
    return format == Format::Svg || format == Format::Pdf;
}

void checkShapes(const RenderArguments& arguments) {
    const QString reason = tr("vector graphics are made of shapes.");
    refuseIf(arguments.points && styleOf(arguments) != io::ShapeStyle::Points, "--points",
             tr("vector graphics are made of copies; to draw points, use --svg points."));
    refuseIf(arguments.depth && styleOf(arguments) == io::ShapeStyle::Points, "--depth",
             tr("points have no levels of copies."));
    refuseIf(arguments.algorithm != "density", "--algorithm", reason);
    refuseIf(arguments.iterations.has_value(), "--iterations", tr("for vector graphics, use --depth."));
    refuseIf(arguments.gamma.has_value(), "--gamma", reason);
    refuseIf(arguments.brightness.has_value(), "--brightness", reason);
    refuseIf(arguments.contrast.has_value(), "--contrast", reason);
    refuseIf(arguments.vibrancy.has_value(), "--vibrancy", reason);
    refuseIf(arguments.supersample.has_value(), "--supersample", reason);
    refuseIf(arguments.bits.has_value(), "--bits", reason);
    refuseIf(arguments.quality.has_value(), "--quality", reason);
    refuseIf(arguments.legend, "--legend", tr("it applies only to pictures made of pixels."));
    refuseIf(arguments.dpi.has_value(), "--dpi", tr("vector graphics have no resolution."));
    shapesOf(arguments);
}

// What only entries in space understand; which the entry is, is not known yet.
bool isViewInSpace(const std::string& text) {
    return std::ranges::count(text, ',') == 3;
}
bool isColourOfSolids(const RenderArguments& arguments) {
    return arguments.colour == "height" || arguments.colour == "depth";
}

// Every value is looked at before a file is read.
Format checked(RenderArguments& arguments) {
    if (arguments.palette) arguments.readPalette = paletteArgument("--palette", *arguments.palette);
    if (arguments.iterations) arguments.steps = stepsOf(*arguments.iterations);
    const Format format = formatOf(arguments);
    refuseUnsupported(arguments, format);
    attractor::Appearance appearance;
    if (!isColourOfSolids(arguments)) applyAppearance(appearance, arguments);
    const bool isOpen = pictureSizeArgument("--size", arguments.size).isEmpty();
    if (arguments.view) {
        if (!isViewInSpace(*arguments.view)) viewArgument("--view", *arguments.view);
        refuseIf(arguments.margin.has_value(), "--margin", tr("--view already defines the view."));
        refuseIf(isOpen, "--size with one side", tr("--view has no proportions; give both sides."));
    }
    if (arguments.viewRotation) rotationArgument("--view-rotation", *arguments.viewRotation);
    if (arguments.margin) marginArgument("--margin", *arguments.margin);
    if (arguments.threads) integerArgument("--threads", *arguments.threads, 1, 1024);
    if (arguments.points) countArgument("--points", *arguments.points, 1, maxPoints);
    wholeArgument("--seed", arguments.seed);
    if (arguments.frame) momentArgument("--frame", *arguments.frame);
    refuseIf(isStrip(arguments) && depthOf(arguments) == io::PictureFormat::Depth::Bits16,
             arguments.bits ? "--bits 16" : ".exr", tr("a strip of steps has 8 bits per channel."));
    dotsPerInch(arguments);
    overlayOf(arguments);
    if (format == Format::Sum) {
        const QString reason = tr("a .sum file holds only the numbers of points.");
        refuseIf(arguments.overlay.has_value(), "--overlay", reason);
        refuseIf(arguments.legend, "--legend", reason);
    }
    refuseIf(arguments.legend && isStrip(arguments), "--legend", tr("the steps are drawn side by side."));
    if (algorithmOf(arguments.algorithm) == attractor::Algorithm::Deterministic && !arguments.iterations)
        throw UsageError{tr("--algorithm deterministic needs --iterations.")};
    if (arguments.simd) selectInstructions(*arguments.simd);
    return format;
}

namespace {

void addColourOptions(Command& command, RenderArguments& arguments) {
    const OptionGroup colours = command.group("Colours");
    colours
        .add("--palette", "PALETTE", &arguments.palette,
             "Palette: its name, or a .gpl, .ggr, .ugr or .map file", "stored in the entry, else Maple")
        .fileName();
    colours.add("--colour,--color", "BY", &arguments.colour,
                "Colour by density, map, address, blend or none; a solid by map, height, depth or none",
                "stored in the entry, else density");
    colours.add("--gamma", "G", &arguments.gamma, "Gamma of the tone curve", "stored in the entry, else 2.2");
    colours.add("--brightness", "B", &arguments.brightness, "Brightness of the tone curve",
                "stored in the entry, else 20");
    colours.add("--contrast", "C", &arguments.contrast,
                "Contrast of the tone curve: above 1, light becomes lighter and dark darker",
                "stored in the entry, else 1");
    colours.add(
        "--vibrancy", "V", &arguments.vibrancy,
        "How far colours keep their hue, 0 to 1: at 0 the gamma acts on each channel, and colours are paler",
        "stored in the entry, else 1");
    colours.add("--background", "COLOUR", &arguments.background,
                "transparent, a name such as white, #rrggbb, or #rrggbbaa with opacity",
                "stored in the entry, else #0d1017");
}

void addShapeOptions(Command& command, RenderArguments& arguments) {
    const OptionGroup file = command.group("File");
    file.add("--to", "FORMAT", &arguments.format, "png, jpg, webp, tiff, exr, svg or pdf",
             "as the output name determines");
    file.add("--svg", "KIND", &arguments.svg, "Kind of vector graphics: structured, outline or points",
             "structured");
    file.add("--depth", "N", &arguments.depth, "Levels of copies in vector graphics",
             "as many as the pixels need");
}

void addPixelOptions(Command& command, RenderArguments& arguments) {
    const OptionGroup file = command.group("File");
    file.add(
        "--bits", "8|16|32", &arguments.bits,
        "Bits per channel: 8 or 16 in .png and .tiff, 8 in .jpg and .webp, 16 or 32 (floating point) in .exr",
        "8; 16 in .exr and for --look normals");
    file.add("--dpi", "D", &arguments.dpi, "Resolution stored in the picture, in dots per inch, 1 to 100000",
             "none; 96 of a solid in .svg and .pdf");
}

void addExplanationOptions(Command& command, RenderArguments& arguments) {
    const OptionGroup group = command.group("Explanations");
    group.add("--overlay", "PARTS", &arguments.overlay,
              "Draw over the picture: maps, hull, cage, fixed-points and numbers, separated by commas; the "
              "view includes the cage and the maps");
    group.flag("--legend", &arguments.legend,
               "Put the table of maps to the right, which makes the picture wider");
}

void addQualityOption(Command& command, RenderArguments& arguments) {
    const OptionGroup file = command.group("File");
    file.add("--quality", "Q", &arguments.quality, "Quality of .jpg and .webp, 1 to 100",
             "92 of .jpg; .webp without loss");
}

void addAlgorithmOptions(Command& command, RenderArguments& arguments) {
    const OptionGroup group = command.group("Algorithm");
    group.add("--algorithm", "NAME", &arguments.algorithm, "density, chaos-game or deterministic", "density");
    group.add(
        "--iterations", "N|M-N", &arguments.iterations,
        "Iterations of the deterministic algorithm; 0-6 draws all from 0 to 6, side by side, or to files of "
        "their own where the output has %i");
}

void addSampleOptions(Command& command, RenderArguments& arguments) {
    const OptionGroup group = command.group("Algorithm");
    group.add("--points", "N", &arguments.points,
              "Samples (density), or points plotted (chaos-game, points in SVG), such as 250000, 1e9 or 2G",
              "100 or 2 per pixel, at least 1M");
    group.add("--supersample", "K", &arguments.supersample, "Cells along each side of a pixel, 1 to 4",
              "stored in the entry, else 1");
    group.add("--seed", "S", &arguments.seed, "Seed of the random numbers", "1");
    group.add("-j,--threads", "N", &arguments.threads, "Threads, 1 to 1024; never changes the picture",
              "all cores");
    group.add("--simd", "SET", &arguments.simd,
              "Instruction set: scalar, sse4, avx2, avx512 or neon; never changes the picture",
              "the fastest");
}

void addViewOptions(Command& command, RenderArguments& arguments) {
    const OptionGroup group = command.group("View and cage");
    group.add("--size", "WxH", &arguments.size,
              "Width and height in pixels; 1200x or x900 keeps the proportions of the fractal", "1200x900");
    group.add("--margin", "PERCENT", &arguments.margin, "Margin around the picture, 0 to less than 50", "5");
    group.add("--view", "CX,CY,HEIGHT", &arguments.view,
              "Centre and height of the view; in space \"tx,ty,tz,height\"", "all of the fractal");
    group.add("--view-rotation", "DEGREES", &arguments.viewRotation,
              "Turn the view of the plane counter-clockwise", "0, or as keyed in an animation");
    group.flag("--y-down", &arguments.yDown, "The y axis points down");
}

void addCageOptions(Command& command, RenderArguments& arguments) {
    const OptionGroup group = command.group("View and cage");
    group.add("--cage", "CORNERS", &arguments.cage,
              "Current corners of the cage: \"x,y x,y x,y\", up to 64; more than three, in space four, bend "
              "the picture");
    group.add("--rest-cage", "CORNERS", &arguments.restCage,
              "Corners at rest: \"x,y x,y x,y\", canonical, box, hull or hull:N; in the plane rectangle, "
              "in space octahedron as well");
    group.add("--frame", "F", &arguments.frame,
              "The moment of an animation in frames, counted from 0, such as 12, 12.5 or 25/2; the view "
              "shows all frames, and the brightness is that of this frame alone",
              "the entry at rest");
}

void addPartOptions(Command& command, RenderArguments& arguments) {
    const OptionGroup group = command.group("Several machines or runs");
    group.add("--part", "I/N", &arguments.part,
              "Draw only part I of N, counting from 0, into a .sum file for merge");
    group.add("--band", "J/M", &arguments.band,
              "Draw only band J of M bands of rows, counting from 0, into a .sum file for merge");
    group.add("--resume", "FILE", &arguments.resume,
              "Add points to the picture in a .sum file, up to --points in all");
}

void addLimitOptions(Command& command, RenderArguments& arguments) {
    const OptionGroup group = command.group("Limits");
    group.add("--time-limit", "SECONDS", &arguments.timeLimit,
              "Stop, with exit status 3, if the pictures are not finished by then", "no limit");
    group.add("--memory-limit", "MB", &arguments.memoryLimit,
              "Stop, with exit status 3, rather than use more memory; 64 to 1000000", "no limit");
}

void addSpaceOptions(Command& command, RenderArguments& arguments) {
    const OptionGroup group = command.group("In space");
    group.add("--orbit", "AZ,EL[,ROLL]", &arguments.orbit,
              "Azimuth, elevation and roll of the camera, in degrees", "30,20");
    group.add("--perspective", "FOV", &arguments.perspective, "Vertical angle of view, in degrees",
              "orthographic");
    group.add(
        "--look", "NAME", &arguments.look,
        "stone, ink (on white), cloud (density), x-ray (coloured by mean depth), depth (16-bit grey) or "
        "normals",
        "that of the entry");
    group.add("--light", "AZ,EL", &arguments.light,
              "Azimuth and elevation of the key light from the line of sight, in degrees", "-40,40");
    group.add("--fog", "F", &arguments.fog, "How fast colours fade with depth, 0 to 100", "0");
    group.add("--slice", "NX,NY,NZ,T,W", &arguments.slice,
              "Keep only the points p with |n·p - T| <= W; without W, those with n·p <= T");
    group.add("--stereo", "NAME", &arguments.stereo,
              "side-by-side (left picture for the left eye) or anaglyph (red and cyan)");
}

} // namespace

void addFrameOptions(Command& command, RenderArguments& arguments) {
    addViewOptions(command, arguments);
    addSpaceOptions(command, arguments);
    addSampleOptions(command, arguments);
    addColourOptions(command, arguments);
    addPixelOptions(command, arguments);
}

void addRenderOptions(Command& command, RenderArguments& arguments) {
    const OptionGroup files = command.group("Files");
    files.argument("FILE...", &arguments.files,
                   "Collections, or pictures with an embedded system; - for standard input");
    files
        .add("-o,--output", "OUT", &arguments.output,
             "Picture to write: .png, .jpg, .webp, .tiff, .exr, .svg or .pdf, or its sums: .sum; - for "
             "standard output; for several, %e is the name of the entry, %n its number, %f its file, %i the "
             "number of iterations")
        .fileName()
        .required();
    addEntriesOption(command, arguments.entries, "the first that can be read");
    addFrameOptions(command, arguments);
    addCageOptions(command, arguments);
    addAlgorithmOptions(command, arguments);
    addPartOptions(command, arguments);
    addLimitOptions(command, arguments);
    addShapeOptions(command, arguments);
    addQualityOption(command, arguments);
    addExplanationOptions(command, arguments);
    command.group("Colours")
        .flag("--list-palettes", &arguments.listPalettes, "List the palettes and exit")
        .question();
    command.group("Several machines or runs")
        .flag("--dry-run", &arguments.dryRun,
              "Report what is wrong with the options and the entries, and draw nothing")
        .excludes("--resume");
    addVerbosityOptions(command, arguments.verbosity);
}

} // namespace cli
