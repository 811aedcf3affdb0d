// SPDX-License-Identifier: MIT
#include "render/render_arguments.h"

#include "options/tr.h"
#include "options/usage_error.h"
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

const std::vector<std::string> formats{"png", "jpg", "webp", "tiff", "exr", "svg", "pdf"}; // of --to
const std::vector<std::string> overlayParts{"maps", "hull", "cage", "fixed-points", "numbers"};

// All steps in one picture.
bool isStrip(const RenderArguments& arguments) {
    return arguments.steps().first < arguments.steps().last && !hasIterations(fileNameOf(arguments.output));
}

Format formatOf(const RenderArguments& arguments) {
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

// "6", or "0-6" for all from 0 to 6.
Steps stepsArgument(const std::string& option, const std::string& text) {
    constexpr int maxSteps = 1000;
    const std::size_t dash = text.find('-', 1);
    const auto number = [&](const std::string& part) { return integerArgument(option, part, 0, maxInt); };
    if (dash == std::string::npos) return {number(text), number(text)};
    const Steps steps{number(text.substr(0, dash)), number(text.substr(dash + 1))};
    if (steps.last < steps.first || steps.last - steps.first >= maxSteps)
        throw UsageError{tr("--iterations “%1” is not valid: a range such as 0-6 must be ascending and have "
                            "at most %2 numbers.")
                             .arg(QString::fromStdString(text))
                             .arg(maxSteps)};
    return steps;
}

// "2/16".
Share shareArgument(const std::string& option, const std::string& text) {
    constexpr int maxParts = 1'000'000;
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
                .arg(QString::fromStdString(option), whole, QString::number(maxParts))};
    return share;
}

std::uint64_t memoryArgument(const std::string& option, const std::string& text) {
    constexpr int minMegabytes = 64, maxMegabytes = 1'000'000;
    return std::uint64_t(integerArgument(option, text, minMegabytes, maxMegabytes)) << 20;
}

int bitsArgument(const std::string& option, const std::string& text) {
    const std::vector<std::string> bits{"8", "16", "32"};
    return std::stoi(bits[choiceArgument(option, text, bits)]);
}

std::string formatArgument(const std::string& option, const std::string& text) {
    return formats[choiceArgument(option, text, formats)];
}

io::PictureOverlay overlayArgument(const std::string& option, const std::string& text) {
    io::PictureOverlay overlay;
    bool* const parts[] = {&overlay.maps, &overlay.hull, &overlay.cage, &overlay.fixedPoints,
                           &overlay.numbers};
    const QStringList names = QString::fromStdString(text).split(u',');
    for (const QString& name : names)
        *parts[choiceArgument(option, name.trimmed().toStdString(), overlayParts)] = true;
    return overlay;
}

NumberList orbitArgument(const std::string&, const std::string& text) {
    NumberList angles = numbersArgument({}, text);
    if (angles.values.size() != 2 && angles.values.size() != 3)
        throw UsageError{tr("--orbit “%1” is not valid: it must be azimuth, elevation and perhaps roll in "
                            "degrees, such as 30,20.")
                             .arg(QString::fromStdString(text))};
    return angles;
}

NumberList lightArgument(const std::string&, const std::string& text) {
    NumberList angles = numbersArgument({}, text);
    if (angles.values.size() != 2)
        throw UsageError{tr("--light “%1” is not valid: it must be azimuth and elevation in degrees from the "
                            "line of sight, such as -40,40.")
                             .arg(QString::fromStdString(text))};
    return angles;
}

double perspectiveArgument(const std::string& option, const std::string& text) {
    const double angle = positiveArgument(option, text);
    if (angle < 180) return angle;
    throw UsageError{tr("--perspective “%1” is not valid: it must be an angle of view below 180 degrees.")
                         .arg(QString::fromStdString(text))};
}

attractor::LookInSpace lookArgument(const std::string&, const std::string& text) {
    if (const auto look = ifs::named<attractor::LookInSpace>(text)) return *look;
    throw UsageError{tr("--look must be stone, ink, cloud, x-ray, depth or normals, not “%1”.")
                         .arg(QString::fromStdString(text))};
}

// Three numbers in the plane, four in space: which the entry is, is not known yet.
NumberList viewNumbers(const std::string& option, const std::string& text) {
    NumberList view = numbersArgument(option, text);
    if (view.values.size() != 4) viewArgument(option, text);
    return view;
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

int threadsOf(const std::optional<int>& threads) {
    return threads.value_or(io::threadsOfThisMachine());
}

io::SvgFormat shapesOf(const RenderArguments& arguments) {
    io::SvgFormat format;
    format.depth = arguments.depth;
    format.style = arguments.svg.value_or(io::ShapeStyle::Structured);
    format.seed = arguments.seed;
    if (arguments.points) format.points = *arguments.points;
    format.overlay = arguments.overlay;
    return format;
}

void applyAppearance(attractor::Appearance& appearance, const RenderArguments& arguments) {
    if (arguments.colour) {
        // Says which words there are for entries in the plane.
        if (!arguments.colour->inPlane)
            choiceArgument("--colour", arguments.colour->word, wordsOf(coloursInPlane));
        appearance.colourBy = *arguments.colour->inPlane;
    }
    if (arguments.palette) appearance.palette = *arguments.palette;
    if (arguments.gamma) appearance.gamma = *arguments.gamma;
    if (arguments.brightness) appearance.brightness = *arguments.brightness;
    if (arguments.contrast) appearance.contrast = *arguments.contrast;
    if (arguments.vibrancy) appearance.vibrancy = *arguments.vibrancy;
    if (arguments.background) putOn(appearance, *arguments.background);
    if (arguments.supersample) appearance.supersample = *arguments.supersample;
}

io::PictureFile pictureFileOf(const RenderArguments& arguments) {
    const io::PictureFile file = io::pictureFileOf(suffixOf(arguments)).value_or(io::PictureFile::Png);
    return file == io::PictureFile::ExrHalf && arguments.bits == 32 ? io::PictureFile::ExrFloat : file;
}

io::PictureFormat::Depth depthOf(const RenderArguments& arguments) {
    using enum io::PictureFormat::Depth;
    const bool isOnlyDeep = !io::takes(pictureFileOf(arguments), Bits8);
    return isOnlyDeep || is16Bit(arguments) ? Bits16 : Bits8;
}

bool is16Bit(const RenderArguments& arguments) {
    return arguments.bits == 16;
}

std::optional<int> fittingQuality(const std::optional<int>& quality, std::optional<io::PictureFile> file) {
    const bool hasQuality = file == io::PictureFile::Jpeg || file == io::PictureFile::WebP;
    refuseIf(quality && !hasQuality, "--quality", tr("it applies only to .jpg and .webp."));
    return quality;
}

std::optional<int> qualityOf(const RenderArguments& arguments) {
    return fittingQuality(arguments.quality, pictureFileOf(arguments));
}

namespace {

// What each kind of file holds.
void checkPixels(const RenderArguments& arguments) {
    using enum io::PictureFormat::Depth;
    const io::PictureFile file = pictureFileOf(arguments);
    qualityOf(arguments);
    if (!io::takes(file, Bits8))
        refuseIf(arguments.bits == 8, "--bits 8", tr("OpenEXR has 16 or 32 bits per channel."));
    else
        refuseIf(arguments.bits == 32, "--bits 32", tr("only .exr has 32 bits per channel."));
    refuseIf(is16Bit(arguments) && !io::takes(file, Bits16), "--bits 16",
             tr(".jpg and .webp have 8 bits per channel."));
}

// What makes no sense for the format, whatever the entry. Nothing is ignored silently.
void refuseUnsupported(const RenderArguments& arguments, Format format) {
    checkPixels(arguments);
    if (!isOfShapes(format))
        arguments.given.refuse({"--svg", "--depth"},
                               tr("it applies only to vector graphics (.svg and .pdf)."));
    const bool deterministic = arguments.algorithm == attractor::Algorithm::Deterministic;
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
    const bool hasPoints = shapesOf(arguments).style == io::ShapeStyle::Points;
    refuseIf(arguments.points && !hasPoints, "--points",
             tr("vector graphics are made of copies; to draw points, use --svg points."));
    refuseIf(arguments.depth && hasPoints, "--depth", tr("points have no levels of copies."));
    refuseIf(arguments.algorithm != attractor::Algorithm::Density, "--algorithm", reason);
    arguments.given.refuse({"--iterations"}, tr("for vector graphics, use --depth."));
    arguments.given.refuse(Tone | Cells | Rows, reason);
    arguments.given.refuse({"--legend"}, tr("it applies only to pictures made of pixels."));
    arguments.given.refuse({"--dpi"}, tr("vector graphics have no resolution."));
    if (arguments.points)
        countArgument("--points", std::to_string(*arguments.points), 1, io::SvgFormat::maxPoints);
}

Format checked(const RenderArguments& arguments) {
    const Format format = formatOf(arguments);
    refuseUnsupported(arguments, format);
    if (arguments.view) {
        arguments.given.refuse({"--margin"}, tr("--view already defines the view."));
        refuseIf(arguments.size.isEmpty(), "--size with one side",
                 tr("--view has no proportions; give both sides."));
    }
    refuseIf(isStrip(arguments) && depthOf(arguments) == io::PictureFormat::Depth::Bits16,
             arguments.bits ? "--bits 16" : ".exr", tr("a strip of steps has 8 bits per channel."));
    if (format == Format::Sum)
        arguments.given.refuse({"--overlay", "--legend"},
                               tr("a .sum file holds only the numbers of points."));
    refuseIf(arguments.legend && isStrip(arguments), "--legend", tr("the steps are drawn side by side."));
    if (arguments.algorithm == attractor::Algorithm::Deterministic && !arguments.iterations)
        throw UsageError{tr("--algorithm deterministic needs --iterations.")};
    if (arguments.simd) selectInstructions(*arguments.simd);
    return format;
}

Option& addQualityOption(const OptionGroup& group, std::optional<int>& quality) {
    return group
        .add("--quality", "Q", parsed(&quality, integerFrom(1, 100)), "Quality of .jpg and .webp, 1 to 100",
             "92 of .jpg; .webp without loss")
        .is(Rows);
}

Option& addThreadsOption(const OptionGroup& group, std::optional<int>& threads) {
    return group
        .add("-j,--threads", "N", parsed(&threads, threadsArgument),
             "Threads, 1 to 1024; never changes the picture", "all cores")
        .is(Work);
}

Option& addSimdOption(const OptionGroup& group, std::optional<std::string>& simd) {
    return group
        .add("--simd", "SET", &simd,
             "Instruction set: scalar, sse4, avx2, avx512 or neon; never changes the picture", "the fastest")
        .completedBy(Completion::Kind::Words, {"scalar", "sse4", "avx2", "avx512", "neon"})
        .is(Work);
}

Option& addSeedOption(const OptionGroup& group, std::uint64_t& seed) {
    return group.add("--seed", "S", parsed(&seed, wholeArgument), "Seed of the random numbers", "1")
        .is(Picture);
}

Option& addSizeOption(const OptionGroup& group, QSize& size) {
    return group
        .add("--size", "WxH", parsed(&size, pictureSizeArgument),
             "Width and height in pixels; 1200x or x900 keeps the proportions of the fractal", "1200x900")
        .is(Picture);
}

Option& addBackgroundOption(const OptionGroup& group, std::optional<attractor::Rgba>& background) {
    return group
        .add("--background", "COLOUR", parsed(&background, colourArgument),
             "transparent, a name such as white, #rrggbb, or #rrggbbaa with opacity",
             "stored in the entry, else #0d1017")
        .completedBy(Completion::Kind::Words, {"transparent", "black", "white"})
        .is(Picture);
}

namespace {

void addColourOptions(Command& command, RenderArguments& arguments) {
    const OptionGroup colours = command.group("Colours");
    colours
        .add("--palette", "PALETTE", parsed(&arguments.palette, paletteArgument),
             "Palette: its name, or a .gpl, .ggr, .ugr or .map file", "stored in the entry, else Maple")
        .completedBy(Completion::Kind::Palettes)
        .is(Picture | Colours)
        .fileName();
    colours
        .add("--colour,--color", "BY", parsed(&arguments.colour, meaningArgument),
             "Colour by density, map, address, blend or none; a solid by map, height, depth or none",
             "stored in the entry, else density")
        .completedBy(Completion::Kind::Words,
                     {"density", "map", "address", "blend", "height", "depth", "none"})
        .is(Picture | Colours);
    colours
        .add("--gamma", "G", parsed(&arguments.gamma, positiveArgument), "Gamma of the tone curve",
             "stored in the entry, else 2.2")
        .is(Picture | Tone);
    colours
        .add("--brightness", "B", parsed(&arguments.brightness, positiveArgument),
             "Brightness of the tone curve", "stored in the entry, else 20")
        .is(Picture | Tone);
    colours
        .add("--contrast", "C", parsed(&arguments.contrast, positiveArgument),
             "Contrast of the tone curve: above 1, light becomes lighter and dark darker",
             "stored in the entry, else 1")
        .is(Picture | Tone);
    colours
        .add("--vibrancy", "V", parsed(&arguments.vibrancy, numberFrom(0, 1)),
             "How far colours keep their hue, 0 to 1: at 0 the gamma acts on each channel, and colours are "
             "paler",
             "stored in the entry, else 1")
        .is(Picture | Tone);
    addBackgroundOption(colours, arguments.background);
}

void addShapeOptions(Command& command, RenderArguments& arguments) {
    const OptionGroup file = command.group("File");
    file.add("--to", "FORMAT", parsed(&arguments.format, formatArgument),
             "png, jpg, webp, tiff, exr, svg or pdf", "as the output name determines")
        .completedBy(Completion::Kind::Words, formats);
    file.add("--svg", "KIND", choice(&arguments.svg),
             "Kind of vector graphics: structured, outline or points", "structured")
        .is(InPlane);
    file.add("--depth", "N", parsed(&arguments.depth, integerFrom(0, maxInt)),
             "Levels of copies in vector graphics", "as many as the pixels need")
        .is(InPlane);
}

void addPixelOptions(Command& command, RenderArguments& arguments) {
    const OptionGroup file = command.group("File");
    file.add("--bits", "8|16|32", parsed(&arguments.bits, bitsArgument),
             "Bits per channel: 8 or 16 in .png and .tiff, 8 in .jpg and .webp, 16 or 32 (floating point) in "
             ".exr",
             "8; 16 in .exr and for --look normals")
        .completedBy(Completion::Kind::Words, {"8", "16", "32"})
        .is(Picture | Rows);
    file.add("--dpi", "D", parsed(&arguments.dpi, numberFrom(1, 100'000)),
             "Resolution stored in the picture, in dots per inch, 1 to 100000",
             "none; 96 of a solid in .svg and .pdf")
        .is(Picture);
}

void addExplanationOptions(Command& command, RenderArguments& arguments) {
    const OptionGroup group = command.group("Explanations");
    group
        .add("--overlay", "PARTS", parsed(&arguments.overlay, overlayArgument),
             "Draw over the picture: maps, hull, cage, fixed-points and numbers, separated by commas; the "
             "view includes the cage and the maps")
        .completedBy(Completion::Kind::Words, overlayParts)
        .is(Picture);
    group
        .flag("--legend", &arguments.legend,
              "Put the table of maps to the right, which makes the picture wider")
        .is(Picture);
}

void addAlgorithmOptions(Command& command, RenderArguments& arguments) {
    const OptionGroup group = command.group("Algorithm");
    group.add("--algorithm", "NAME", choice(&arguments.algorithm), "density, chaos-game or deterministic",
              "density");
    group
        .add("--iterations", "N|M-N", parsed(&arguments.iterations, stepsArgument),
             "Iterations of the deterministic algorithm; 0-6 draws all from 0 to 6, side by side, or to "
             "files of "
             "their own where the output has %i")
        .is(InPlane);
}

void addSampleOptions(Command& command, RenderArguments& arguments) {
    const OptionGroup group = command.group("Algorithm");
    group
        .add("--points", "N", parsed(&arguments.points, countFrom(1, maxPoints)),
             "Samples (density), or points plotted (chaos-game, points in SVG), such as 250000, 1e9 or 2G",
             "100 or 2 per pixel, at least 1M")
        .is(Samples);
    group
        .add("--supersample", "K", parsed(&arguments.supersample, integerFrom(1, 4)),
             "Cells along each side of a pixel, 1 to 4", "stored in the entry, else 1")
        .completedBy(Completion::Kind::Words, {"1", "2", "3", "4"})
        .is(Picture | Cells);
    addSeedOption(group, arguments.seed);
    addThreadsOption(group, arguments.threads);
    addSimdOption(group, arguments.simd);
}

void addViewOptions(Command& command, RenderArguments& arguments) {
    const OptionGroup group = command.group("View and cage");
    addSizeOption(group, arguments.size);
    group
        .add("--margin", "PERCENT", parsed(&arguments.margin, marginArgument),
             "Margin around the picture, 0 to less than 50", "5")
        .is(Picture);
    group
        .add("--view", "CX,CY,HEIGHT", parsed(&arguments.view, viewNumbers),
             "Centre and height of the view; in space \"tx,ty,tz,height\"", "all of the fractal")
        .is(Picture);
    group
        .add("--view-rotation", "DEGREES", parsed(&arguments.viewRotation, rotationArgument),
             "Turn the view of the plane counter-clockwise", "0, or as keyed in an animation")
        .is(Picture | InPlane);
    group.flag("--y-down", &arguments.yDown, "The y axis points down").is(Picture | InPlane);
}

void addCageOptions(Command& command, RenderArguments& arguments) {
    const OptionGroup group = command.group("View and cage");
    group
        .add("--cage", "CORNERS", &arguments.cage,
             "Current corners of the cage: \"x,y x,y x,y\", up to 64; more than three, in space four, bend "
             "the picture")
        .is(Picture);
    group
        .add("--rest-cage", "CORNERS", &arguments.restCage,
             "Corners at rest: \"x,y x,y x,y\", canonical, box, hull or hull:N; in the plane rectangle, "
             "in space octahedron as well")
        .completedBy(Completion::Kind::Words, {"canonical", "box", "rectangle", "octahedron", "hull"})
        .is(Picture);
    group
        .add("--frame", "F", parsed(&arguments.frame, momentArgument),
             "The moment of an animation in frames, counted from 0, such as 12, 12.5 or 25/2; the view "
             "shows all frames, and the brightness is that of this frame alone",
             "the entry at rest")
        .is(Picture);
}

void addPartOptions(Command& command, RenderArguments& arguments) {
    const OptionGroup group = command.group("Several machines or runs");
    group.add("--part", "I/N", parsed(&arguments.part, shareArgument),
              "Draw only part I of N, counting from 0, into a .sum file for merge");
    group.add("--band", "J/M", parsed(&arguments.band, shareArgument),
              "Draw only band J of M bands of rows, counting from 0, into a .sum file for merge");
    group
        .add("--resume", "FILE", &arguments.resume,
             "Add points to the picture in a .sum file, up to --points in all")
        .completedBy(Completion::Kind::Files, {"sum"});
}

void addLimitOptions(Command& command, RenderArguments& arguments) {
    const OptionGroup group = command.group("Limits");
    group
        .add("--time-limit", "SECONDS", parsed(&arguments.timeLimit, secondsArgument),
             "Stop, with exit status 3, if the pictures are not finished by then", "no limit")
        .is(Work);
    group
        .add("--memory-limit", "MB", parsed(&arguments.memoryLimit, memoryArgument),
             "Stop, with exit status 3, rather than use more memory; 64 to 1000000", "no limit")
        .is(Work);
}

void addSpaceOptions(Command& command, RenderArguments& arguments) {
    using attractor::Stereo;
    static constexpr auto eyes = std::to_array<ifs::Named<Stereo>>(
        {{Stereo::SideBySide, "side-by-side"}, {Stereo::Anaglyph, "anaglyph"}});
    const OptionGroup group = command.group("In space");
    group
        .add("--orbit", "AZ,EL[,ROLL]", parsed(&arguments.orbit, orbitArgument),
             "Azimuth, elevation and roll of the camera, in degrees", "30,20")
        .is(Picture | InSpace);
    group
        .add("--perspective", "FOV", parsed(&arguments.perspective, perspectiveArgument),
             "Vertical angle of view, in degrees", "orthographic")
        .is(Picture | InSpace);
    group
        .add("--look", "NAME", parsed(&arguments.look, lookArgument),
             "stone, ink (on white), cloud (density), x-ray (coloured by mean depth), depth (16-bit grey) or "
             "normals",
             "that of the entry")
        .completedBy(Completion::Kind::Words, wordsOf(ifs::names<attractor::LookInSpace>))
        .is(Picture | InSpace);
    group
        .add("--light", "AZ,EL", parsed(&arguments.light, lightArgument),
             "Azimuth and elevation of the key light from the line of sight, in degrees", "-40,40")
        .is(Picture | InSpace | Light);
    group
        .add("--fog", "F", parsed(&arguments.fog, numberFrom(0, 100)),
             "How fast colours fade with depth, 0 to 100", "0")
        .is(Picture | InSpace | Light);
    group
        .add("--slice", "NX,NY,NZ,T,W", parsed(&arguments.slice, numbersArgument),
             "Keep only the points p with |n·p - T| <= W; without W, those with n·p <= T")
        .is(Picture | InSpace);
    group
        .add("--stereo", "NAME", choice(&arguments.stereo, std::span<const ifs::Named<Stereo>>(eyes)),
             "side-by-side (left picture for the left eye) or anaglyph (red and cyan)")
        .is(Picture | InSpace);
}

} // namespace

void addFrameOptions(Command& command, RenderArguments& arguments) {
    command.given = &arguments.given;
    addViewOptions(command, arguments);
    addSpaceOptions(command, arguments);
    addSampleOptions(command, arguments);
    addColourOptions(command, arguments);
    addPixelOptions(command, arguments);
}

void addRenderOptions(Command& command, RenderArguments& arguments) {
    const OptionGroup files = command.group("Files");
    files
        .argument("FILE...", &arguments.files,
                  "Collections, or pictures with an embedded system; - for standard input")
        .is(Picture);
    files
        .add("-o,--output", "OUT", &arguments.output,
             "Picture to write: .png, .jpg, .webp, .tiff, .exr, .svg or .pdf, or its sums: .sum; - for "
             "standard output; for several, %e is the name of the entry, %n its number, %f its file, %i the "
             "number of iterations")
        .completedBy(Completion::Kind::Files,
                     {"png", "jpg", "jpeg", "webp", "tif", "tiff", "exr", "svg", "pdf", "sum"})
        .fileName()
        .required();
    addEntriesOption(command, arguments.entries, "the first that can be read").is(Picture);
    addFrameOptions(command, arguments);
    addCageOptions(command, arguments);
    addAlgorithmOptions(command, arguments);
    addPartOptions(command, arguments);
    addLimitOptions(command, arguments);
    addShapeOptions(command, arguments);
    addQualityOption(command.group("File"), arguments.quality);
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
