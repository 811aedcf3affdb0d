// SPDX-License-Identifier: MIT
#pragma once

#include "process/progress_bar.h"

#include "attractor/request/appearance.h"
#include "attractor/request/render_request.h"
#include "io/overlay/picture_overlay.h"
#include "io/picture/vector/svg_writer.h"
#include "io/raster/picture_writer.h"

#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

// The options of barycage-cli render. What makes no sense throws UsageError with a sentence that names the
// option.
namespace cli {

struct Command;

constexpr int maxInt = std::numeric_limits<int>::max();
constexpr std::uint64_t maxPoints = std::numeric_limits<std::uint64_t>::max();

enum class Format { Pixels, Svg, Pdf, Sum };
bool isOfShapes(Format format); // but of a solid: a picture of pixels embedded in one

// Numbers of iterations, from the first to the last.
struct Steps {
    int first = 0;
    int last = 0;
};

using OptionText = std::optional<std::string>; // as typed; nullopt: not given

struct AppearanceOptions {
    OptionText palette, colour, gamma, brightness, contrast, vibrancy, background;
    std::optional<attractor::Palette> readPalette; // that `palette` names
};

struct SpaceOptions {
    OptionText orbit, perspective, look, light, fog, slice, stereo;
};

struct FrameOptions { // of an animation
    OptionText frame;
    OptionText shutter; // in degrees
    std::string exposure = "smooth";
};

struct PartOptions { // of a picture made on several machines, or in several runs
    OptionText part, band, resume;
};

struct ResourceOptions {
    OptionText threads, simd, timeLimit, memoryLimit;
};

struct RenderArguments : AppearanceOptions, SpaceOptions, FrameOptions, PartOptions, ResourceOptions {
    std::vector<std::string> files;
    std::vector<std::string> entries;
    std::string output;
    std::string format;
    std::string size = "1200x900";
    std::string seed = "1";
    std::string algorithm = "density";
    OptionText points, iterations, supersample;
    OptionText view, viewRotation, margin, cage, restCage;
    OptionText depth, bits, quality, dpi;
    OptionText svg, overlay;
    bool yDown = false;
    bool legend = false;
    bool listPalettes = false;
    bool dryRun = false;
    Verbosity verbosity;
    Steps steps; // that `iterations` asks for
};

void addRenderOptions(Command& command, RenderArguments& arguments);
// Those that animate has as well: view, space, samples, colours, bits and resolution.
void addFrameOptions(Command& command, RenderArguments& arguments);

// Looks at every value before a file is read, and reads the palette.
Format checked(RenderArguments& arguments);

void selectInstructions(const std::string& name); // --simd
void refuseIf(bool given, const char* option, const QString& reason);
// Of an entry in the plane as shapes: what makes no sense, or has a value out of its range.
void checkShapes(const RenderArguments& arguments);
attractor::Algorithm algorithmOf(const std::string& text);
io::SvgFormat shapesOf(const RenderArguments& arguments);
void applyAppearance(attractor::Appearance& appearance, const RenderArguments& arguments);
QString suffixOf(const RenderArguments& arguments); // of the file, by --to or the name of the output
// What a picture of pixels is written as, by --to or the name of the output, with --bits.
io::PictureFile pictureFileOf(const RenderArguments& arguments);
io::PictureFormat::Depth depthOf(const RenderArguments& arguments); // of the rows that its writer takes
bool is16Bit(const RenderArguments& arguments);
std::optional<int> qualityOf(const RenderArguments& arguments);
// --quality of a picture of this kind; none: no picture.
std::optional<int> qualityArgument(const std::optional<std::string>& quality,
                                   std::optional<io::PictureFile> file);
io::PictureOverlay overlayOf(const RenderArguments& arguments);
std::optional<double> dotsPerInch(const RenderArguments& arguments);
std::optional<std::chrono::duration<double>> timeLimitOf(const RenderArguments& arguments);
std::optional<std::uint64_t> memoryLimitOf(const RenderArguments& arguments); // in bytes

} // namespace cli
