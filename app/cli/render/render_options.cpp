// SPDX-License-Identifier: MIT
#include "render/render_arguments.h"

#include "options/parser.h"
#include "options/tr.h"
#include "options/usage_error.h"
#include "process/input.h"
#include "process/picture_suffixes.h"

#include "io/text/number.h"

#include <QStringList>

namespace cli {

namespace {

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

std::vector<std::string> formatWords() {
    return usualSuffixes(anyPicture, {"svg", "pdf"});
}

std::string formatArgument(const std::string& option, const std::string& text) {
    const std::vector<std::string> formats = formatWords();
    return formats[choiceArgument(option, text, formats)];
}

io::PictureOverlay overlayArgument(const std::string& option, const std::string& text) {
    io::PictureOverlay overlay;
    const std::vector<std::string> known = wordsOf(io::overlayParts);
    const QStringList names = QString::fromStdString(text).split(u',');
    for (const QString& name : names)
        overlay.*io::overlayParts[choiceArgument(option, name.trimmed().toStdString(), known)].isShown = true;
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

// Three numbers in the plane, four in space: which the entry is, is not known yet.
NumberList viewNumbers(const std::string& option, const std::string& text) {
    NumberList view = numbersArgument(option, text);
    if (view.values.size() != 4) viewArgument(option, text);
    return view;
}

} // namespace

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

void addNumberOption(const OptionGroup& group, const NumberOption& option, std::optional<double>& place) {
    const attractor::AppearanceNumber& number = numberOf(option);
    const std::string names = std::string("--") + number.key;
    const std::string standard =
        "stored in the entry, else " + io::formatNumber(attractor::Appearance().*option.member).toStdString();
    const bool isFactor = number.scale == attractor::AppearanceNumber::Scale::Factor;
    const Value value = isFactor ? parsed(&place, positiveArgument)
                                 : parsed(&place, numberFrom(number.lowest, number.highest));
    const bool isTone = number.part == attractor::AppearanceNumber::Part::Tone;
    group.add(names, option.valueName, value, option.help, standard).is(Picture | (isTone ? Tone : InPlane));
}

void addColourOptions(Command& command, RenderArguments& arguments) {
    const OptionGroup colours = command.group("Colours");
    colours
        .add("--palette", "PALETTE", parsed(&arguments.palette, paletteArgument),
             "Palette: its name, or a .gpl, .ggr, .ugr or .map file", "stored in the entry, else Maple")
        .moreOf("Of a file, the first palette in it.")
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
    for (std::size_t i = 0; i < numberOptions.size(); ++i)
        addNumberOption(colours, numberOptions[i], arguments.numbers[i]);
    addBackgroundOption(colours, arguments.background);
}

void addShapeOptions(Command& command, RenderArguments& arguments) {
    const OptionGroup file = command.group("File");
    file.add("--to", "FORMAT", parsed(&arguments.format, formatArgument),
             namedSuffixes(anyPicture, tr("or"), {"svg", "pdf"}).remove(u'.').toStdString(),
             "as the output name determines")
        .moreOf("All but PDF contain the system, which barycage-cli can read again.")
        .completedBy(Completion::Kind::Words, formatWords());
    file.add("--svg", "KIND", choice(&arguments.svg),
             "Kind of vector graphics: structured, outline or points", "structured")
        .moreOf("These are copies of copies, the outline of all copies as one path, for cutters and "
                "plotters, and points.")
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
    const std::vector<std::string> parts = wordsOf(io::overlayParts);
    group
        .add("--overlay", "PARTS", parsed(&arguments.overlay, overlayArgument),
             "Draw over the picture: " + listed(parts, tr("and")).toStdString() +
                 ", separated by commas; the view includes the cage and the maps")
        .moreOf("The maps are the images of the cage; the hull is the convex hull of the attractor, "
                "which a cage that bends an entry in space has not. With --view, the view stays as it "
                "is.")
        .completedBy(Completion::Kind::Words, parts)
        .is(Picture);
    group
        .flag("--legend", &arguments.legend,
              "Put the table of maps to the right, which makes the picture wider")
        .is(Picture);
}

void addAlgorithmOptions(Command& command, RenderArguments& arguments) {
    const OptionGroup group = command.group("Algorithm");
    group
        .add("--algorithm", "NAME", choice(&arguments.algorithm), "density, chaos-game or deterministic",
             "density")
        .moreOf("These are progressive rendering, a chaos game with exactly the given number of "
                "points, and iterates of the rest cage.");
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
        .moreOf("The chaos game plots exactly this many.")
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
        .moreOf("By default the view is the certified box of the picture. In space it is the target "
                "and the height that is seen in its plane, by default the certified silhouette.")
        .is(Picture);
    group
        .add("--view-rotation", "DEGREES", parsed(&arguments.viewRotation, rotationArgument),
             "Turn the view of the plane counter-clockwise", "0, or as keyed in an animation")
        .moreOf("The margin is kept around the turned fractal.")
        .is(Picture | InPlane);
    group.flag("--y-down", &arguments.yDown, "The y axis points down")
        .moreOf("As in window coordinates.")
        .is(Picture | InPlane);
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
        .moreOf("hull has 8 corners, in space 16; hull:N in space has 8 to 24. In space the corners "
                "may also be those of a convex polyhedron.")
        .completedBy(Completion::Kind::Words, {"canonical", "box", "rectangle", "octahedron", "hull"})
        .is(Picture);
    group
        .add("--frame", "F", parsed(&arguments.frame, momentArgument),
             "The moment of an animation in frames, counted from 0, such as 12, 12.5 or 25/2; the view "
             "shows all frames, and the brightness is that of this frame alone",
             "the entry at rest")
        .moreOf("Without --view, and without a camera in the animation, the view is that of all its "
                "frames. The brightness is measured as by animate --exposure each, and not as by its "
                "default, which depends on the whole animation.")
        .is(Picture);
}

void addPartOptions(Command& command, RenderArguments& arguments) {
    const OptionGroup group = command.group("Several machines or runs");
    group
        .add("--part", "I/N", parsed(&arguments.part, shareArgument),
             "Draw only part I of N, counting from 0, into a .sum file for merge")
        .moreOf("The parts, drawn with otherwise the same arguments by any machines, merge to the "
                "same bytes as the whole picture. A solid has no samples and is divided with --band. "
                "It cannot be used with --frame.");
    group
        .add("--band", "J/M", parsed(&arguments.band, shareArgument),
             "Draw only band J of M bands of rows, counting from 0, into a .sum file for merge")
        .moreOf("This is for pictures beyond memory. Together with --part, it is a part of the band.");
    group
        .add("--resume", "FILE", &arguments.resume,
             "Add points to the picture in a .sum file, up to --points in all")
        .moreOf("It writes the picture, a .sum file or, with --part or --band, a part of the added "
                "points.")
        .completedBy(Completion::Kind::Files, {"sum"});
}

void addLimitOptions(Command& command, RenderArguments& arguments) {
    const OptionGroup group = command.group("Limits");
    group
        .add("--time-limit", "SECONDS", parsed(&arguments.timeLimit, secondsArgument),
             "Stop, with exit status 3, if the pictures are not finished by then", "no limit")
        .moreOf("No incomplete file is left. This is for thumbnails that a file manager draws without "
                "being asked.")
        .is(Work);
    group
        .add("--memory-limit", "MB", parsed(&arguments.memoryLimit, memoryArgument),
             "Stop, with exit status 3, rather than use more memory; 64 to 1000000", "no limit")
        .is(Work);
}

void addSpaceOptions(Command& command, RenderArguments& arguments) {
    using attractor::Stereo;
    static constexpr std::span<const ifs::Named<Stereo>> all = ifs::names<Stereo>;
    const auto eyes = all.subspan(1); // without the first, Stereo::None
    const OptionGroup group = command.group("In space");
    group
        .add("--orbit", "AZ,EL[,ROLL]", parsed(&arguments.orbit, orbitArgument),
             "Azimuth, elevation and roll of the camera, in degrees", "30,20")
        .moreOf("Azimuth is counted from +z towards +x, elevation upwards, roll clockwise.")
        .is(Picture | InSpace);
    group
        .add("--perspective", "FOV", parsed(&arguments.perspective, perspectiveArgument),
             "Vertical angle of view, in degrees", "orthographic")
        .is(Picture | InSpace);
    group
        .add("--look", "NAME", choice(&arguments.look),
             "stone, ink (on white), cloud (density), x-ray (coloured by mean depth), depth (16-bit grey) or "
             "normals",
             "that of the entry")
        .moreOf("Stone is a lit solid, ink the same with dark creases, cloud the density of the "
                "attractor, x-ray the density coloured by its mean depth; depth and normals are data "
                "for other programs. In a 16-bit grey PNG of the depth of the nearest points, a pixel "
                "V shows the depth near + (far - near) V/65534, with near and far in the text fields "
                "barycage:near and barycage:far of the file, along the view from the plane of the "
                "target; 65535 means that nothing is visible. Normals are (n + 1)/2 of the full "
                "scale, red to the right, green up and blue towards the eye. Solids are drawn with "
                "--supersample 2 unless it is given.")
        .is(Picture | InSpace);
    group
        .add("--light", "AZ,EL", parsed(&arguments.light, lightArgument),
             "Azimuth and elevation of the key light from the line of sight, in degrees", "-40,40")
        .moreOf("To the right and up.")
        .is(Picture | InSpace | Light);
    group
        .add("--fog", "F", parsed(&arguments.fog, numberFrom(0, 100)),
             "How fast colours fade with depth, 0 to 100", "0")
        .moreOf("A fraction exp(-F) of the colour remains at the farthest point.")
        .is(Picture | InSpace | Light);
    group
        .add("--slice", "NX,NY,NZ,T,W", parsed(&arguments.slice, numbersArgument),
             "Keep only the points p with |n·p - T| <= W; without W, those with n·p <= T")
        .moreOf("The slice is at least a pixel thick. The normal need not be a unit vector: T and W "
                "are in the units of n·p. By default the slice of the entry, if it has one.")
        .is(Picture | InSpace);
    group
        .add("--stereo", "NAME", choice(&arguments.stereo, eyes),
             "side-by-side (left picture for the left eye) or anaglyph (red and cyan)")
        .moreOf("The eyes are a thirtieth of the distance to the target apart. Side by side, each "
                "picture has half the width; in the anaglyph, red is before the left eye and cyan "
                "before the right one.")
        .is(Picture | InSpace);
}

// Frames of an animation have pixels alone.
void letSizeBeOnPaper(Command& command, RenderArguments& arguments) {
    Option& size = command.option("--size");
    size.place = Place(ReadValue([&arguments](const std::string& option, const std::string& text) {
        arguments.millimetres = paperSizeArgument(option, text);
        if (!arguments.millimetres)
            arguments.size = pictureSizeArgument(option, text);
        else
            settlePaperSize(arguments, true); // for shapes until the kind of picture is known
    }));
    size.description =
        "Width and height in pixels, or on paper, such as 58mmx40mm; 1200x, x900 or 58mmx keeps "
        "the proportions of the fractal";
    size.moreOf("On paper, .svg and .pdf have exactly this size; pictures of pixels have the resolution "
                "of --dpi, else 300 dots per inch.");
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
             "Picture to write: " + namedSuffixes(anyPicture, tr("or"), {"svg", "pdf"}).toStdString() +
                 ", or its sums: .sum; - for standard output; for several, %e is the name of the entry, %n "
                 "its "
                 "number, %f its file, %i the number of iterations")
        .moreOf("%% is a per cent sign. The names of folders contain no placeholders: % is a letter "
                "there. Nothing is drawn if two pictures would be written to one file.")
        .completedBy(Completion::Kind::Files, pictureSuffixes(anyPicture, {"svg", "pdf", "sum"}))
        .fileName()
        .required();
    addEntriesOption(command, arguments.entries, "the first that can be read").is(Picture);
    addFrameOptions(command, arguments);
    letSizeBeOnPaper(command, arguments);
    addCageOptions(command, arguments);
    addAlgorithmOptions(command, arguments);
    addPartOptions(command, arguments);
    addLimitOptions(command, arguments);
    addShapeOptions(command, arguments);
    addQualityOption(command.group("File"), arguments.quality);
    addExplanationOptions(command, arguments);
    command.group("Colours")
        .flag("--list-palettes", &arguments.listPalettes, "List the palettes and exit")
        .moreOf("More than two hundred are made of two dozen hues, such as Crimson Glow; the built-in "
                "ones are Maple, Fern, Glacier, Orchid, Aurora, Dusk, Copper, Lagoon, Silver, Ink, "
                "Herbarium, Sanguine and Cyanotype.")
        .question();
    command.group("Several machines or runs")
        .flag("--dry-run", &arguments.dryRun,
              "Report what is wrong with the options and the entries, and draw nothing")
        .excludes("--resume");
    addVerbosityOptions(command, arguments.verbosity);
}

} // namespace cli
