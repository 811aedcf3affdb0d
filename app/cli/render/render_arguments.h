// SPDX-License-Identifier: MIT
#pragma once

#include "process/arguments.h"
#include "process/progress_bar.h"

#include "attractor/light/stereo.h"
#include "attractor/request/appearance_fields.h"
#include "attractor/request/render_request.h"
#include "io/animation/frame_drawing.h"
#include "io/overlay/picture_overlay.h"
#include "io/picture/vector/svg_writer.h"
#include "io/raster/picture_writer.h"

#include <array>
#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

// The options of barycage-cli render. What makes no sense throws UsageError with a sentence that names the
// option.
namespace cli {

constexpr int maxInt = std::numeric_limits<int>::max();
constexpr std::uint64_t maxPoints = std::numeric_limits<std::uint64_t>::max();

enum class Format { Pixels, Svg, Pdf, Sum };
bool isOfShapes(Format format); // true for SVG and PDF, in which solids are pictures of pixels all the same

// Numbers of iterations, from the first to the last.
struct Steps {
    int first = 0;
    int last = 0;
};

// index of count parts, counted from 0.
struct Share {
    int index = 0;
    int count = 1;
};

// An option for each of attractor::appearanceNumbers, in the order of the help.
struct NumberOption {
    double attractor::Appearance::*member;
    const char* valueName;
    const char* help;
};
inline constexpr std::array numberOptions{
    NumberOption{&attractor::Appearance::gamma, "G", "Gamma of the tone curve"},
    NumberOption{&attractor::Appearance::brightness, "B", "Brightness of the tone curve"},
    NumberOption{&attractor::Appearance::contrast, "C",
                 "Contrast of the tone curve: above 1, light becomes lighter and dark darker"},
    NumberOption{&attractor::Appearance::vibrancy, "V",
                 "How far colours keep their hue, 0 to 1: at 0 the gamma acts on each channel, and colours "
                 "are paler"},
    NumberOption{&attractor::Appearance::shadow, "O",
                 "Opacity of the shadow on the ground behind the picture, 0 to 1: at 0 there is none"},
    NumberOption{&attractor::Appearance::shadowLean, "X",
                 "How far to the right the shadow of what is 1 high ends, -10 to 10"},
    NumberOption{&attractor::Appearance::shadowLength, "Y",
                 "How far up the shadow of what is 1 high ends, -10 to 10: below 0 it falls to the front"},
};
static_assert(numberOptions.size() == attractor::appearanceNumbers.size());
const attractor::AppearanceNumber& numberOf(const NumberOption& option);

struct AppearanceOptions {
    std::optional<attractor::Palette> palette;
    std::optional<ColourMeaning> colour;
    std::array<std::optional<double>, numberOptions.size()> numbers; // indexed like numberOptions
    std::optional<attractor::Rgba> background;
    std::optional<int> supersample;
};

struct SpaceOptions {
    std::optional<NumberList> orbit, light, slice;
    std::optional<double> perspective; // degrees
    std::optional<attractor::LookInSpace> look;
    std::optional<double> fog;
    attractor::Stereo stereo = attractor::Stereo::None;
};

struct ViewOptions {
    QSize size{1200, 900}; // pixels; a side of 0 follows from the proportions
    // Size on paper, from which settlePaperSize() computes the size in pixels.
    std::optional<QSizeF> millimetres;
    std::optional<NumberList> view;     // three numbers in the plane, four in space
    std::optional<double> viewRotation; // degrees
    double margin = 5;                  // per cent of the picture
    bool yDown = false;
    // Points, or words for the corners at rest; their meaning depends on the dimension.
    std::optional<std::string> cage, restCage;
};

struct FrameOptions { // options of an animation
    std::optional<animation::Moment> frame;
    document::ShutterAngle shutter = 0;
    io::Exposing exposure = io::Exposing::Smooth;
};

struct PartOptions { // options of a picture drawn on several machines or in several runs
    std::optional<Share> part, band;
    std::optional<std::string> resume; // name of a file of sums
};

struct ResourceOptions {
    std::optional<int> threads;
    std::optional<std::string> simd;
    std::optional<std::chrono::duration<double>> timeLimit;
    std::optional<std::uint64_t> memoryLimit; // bytes
};

struct FileOptions {
    std::string format;
    std::optional<int> bits, quality;
    std::optional<double> dpi;
    std::optional<double> pixelsOfShapes; // pixels per inch; nullopt: the resolution of SVG
    std::optional<io::ShapeStyle> svg;
    std::optional<int> depth;
};

struct RenderArguments : AppearanceOptions,
                         SpaceOptions,
                         ViewOptions,
                         FrameOptions,
                         PartOptions,
                         ResourceOptions,
                         FileOptions {
    std::vector<std::string> files;
    std::vector<std::string> entries;
    std::string output;
    std::uint64_t seed = 1;
    attractor::Algorithm algorithm = attractor::Algorithm::Density;
    std::optional<std::uint64_t> points;
    std::optional<Steps> iterations;
    io::PictureOverlay overlay;
    bool legend = false;
    bool listPalettes = false;
    bool dryRun = false;
    Verbosity verbosity;
    Given given;

    Steps steps() const { return iterations.value_or(Steps()); }
};

void addRenderOptions(Command& command, RenderArguments& arguments);
// Options that animate has as well: view, space, samples, colours, bits and resolution.
void addFrameOptions(Command& command, RenderArguments& arguments);
// Options that other commands than render have as well.
Option& addQualityOption(const OptionGroup& group, std::optional<int>& quality);
Option& addThreadsOption(const OptionGroup& group, std::optional<int>& threads);
Option& addSimdOption(const OptionGroup& group, std::optional<std::string>& simd);
Option& addSeedOption(const OptionGroup& group, std::uint64_t& seed);
Option& addSizeOption(const OptionGroup& group, QSize& size);
// Converts a size on paper to pixels: for shapes, in whole pixels where tenths of a millimetre allow it; for
// pixels, at the resolution that is given or at 300 dpi, which is stored. Has no effect without a size on
// paper.
void settlePaperSize(RenderArguments& arguments, bool hasShapes);
Option& addBackgroundOption(const OptionGroup& group, std::optional<attractor::Rgba>& background);

// Refuses combinations that do not fit before a file is read.
Format checked(const RenderArguments& arguments);

void selectInstructions(const std::string& name); // value of --simd
int threadsOf(const std::optional<int>& threads);
// Refuses options for shapes that make no sense together or are out of range.
void checkShapes(const RenderArguments& arguments);
io::SvgFormat shapesOf(const RenderArguments& arguments);
void applyAppearance(attractor::Appearance& appearance, const RenderArguments& arguments);
QString suffixOf(const RenderArguments& arguments); // suffix of the file, from --to or the name of the output
// The file format of a picture of pixels, by --to or the name of the output, with --bits.
io::PictureFile pictureFileOf(const RenderArguments& arguments);
io::PictureFormat::Depth depthOf(const RenderArguments& arguments); // depth of the rows that the writer takes
bool is16Bit(const RenderArguments& arguments);
std::optional<int> qualityOf(const RenderArguments& arguments);
// --quality of a picture of this kind; none: no picture.
std::optional<int> fittingQuality(const std::optional<int>& quality, std::optional<io::PictureFile> file);

} // namespace cli
