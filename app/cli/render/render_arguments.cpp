// SPDX-License-Identifier: MIT
#include "render/render_arguments.h"

#include "options/tr.h"
#include "options/usage_error.h"
#include "process/input.h"
#include "process/output.h"
#include "process/output_names.h"
#include "process/picture_suffixes.h"

#include "attractor/kernels/kernels.h"
#include "io/picture/picture_writers.h"
#include "io/text/number.h"

#include <QFileInfo>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace cli {

namespace {

// Returns true if all steps go into one picture.
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
        throw UsageError{tr("Give the format for standard output with --to: %1.")
                             .arg(namedSuffixes(anyPicture, tr("or"), {"svg", "pdf"}).remove(u'.'))};
    throw UsageError{
        tr("The picture can be written as %1, and “%2” is none of them.")
            .arg(namedSuffixes(anyPicture, tr("or"), {"svg", "pdf", "sum"}), fileNameOf(arguments.output))};
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
    if (arguments.pixelsOfShapes) format.dotsPerInch = *arguments.pixelsOfShapes;
    return format;
}

const attractor::AppearanceNumber& numberOf(const NumberOption& option) {
    return *std::ranges::find(attractor::appearanceNumbers, option.member,
                              &attractor::AppearanceNumber::member);
}

void settlePaperSize(RenderArguments& arguments, bool hasShapes) {
    if (!arguments.millimetres) return;
    constexpr double inch = 25.4; // millimetres
    const QSizeF& paper = *arguments.millimetres;
    double perMillimetre = arguments.dpi.value_or(300) / inch;
    if (hasShapes) {
        const auto isWhole = [](double pixels) { return std::abs(pixels - std::round(pixels)) < 1e-6; };
        perMillimetre = 4; // close to the resolution of SVG
        while (perMillimetre < 10 &&
               !(isWhole(perMillimetre * paper.width()) && isWhole(perMillimetre * paper.height())))
            ++perMillimetre;
        arguments.pixelsOfShapes = perMillimetre * inch;
    } else {
        arguments.dpi = perMillimetre * inch;
    }
    const auto side = [&](double length) {
        return int(std::min(std::round(length * perMillimetre), double(maxSide)));
    };
    arguments.size = {side(paper.width()), side(paper.height())};
}

void applyAppearance(attractor::Appearance& appearance, const RenderArguments& arguments) {
    if (arguments.colour) {
        // Lists the words for entries in the plane.
        if (!arguments.colour->inPlane)
            choiceArgument("--colour", arguments.colour->word, wordsOf(coloursInPlane));
        appearance.colourBy = *arguments.colour->inPlane;
    }
    if (arguments.palette) appearance.palette = *arguments.palette;
    for (std::size_t i = 0; i < numberOptions.size(); ++i)
        if (const auto& number = arguments.numbers[i]) appearance.*numberOptions[i].member = *number;
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
    const auto hasQuality = [](const io::PictureFileFacts& facts) { return facts.hasQuality; };
    refuseIf(quality && !(file && io::factsOf(*file).hasQuality), "--quality",
             tr("it applies only to %1.").arg(namedSuffixes(hasQuality, tr("and"))));
    return quality;
}

std::optional<int> qualityOf(const RenderArguments& arguments) {
    return fittingQuality(arguments.quality, pictureFileOf(arguments));
}

namespace {

// Refuses depths that the kind of file does not hold.
void checkPixels(const RenderArguments& arguments) {
    using enum io::PictureFormat::Depth;
    const io::PictureFile file = pictureFileOf(arguments);
    const auto isFlat = [](const io::PictureFileFacts& facts) { return !facts.takes16Bits; };
    qualityOf(arguments);
    if (!io::takes(file, Bits8))
        refuseIf(arguments.bits == 8, "--bits 8", tr("OpenEXR has 16 or 32 bits per channel."));
    else
        refuseIf(arguments.bits == 32, "--bits 32", tr("only .exr has 32 bits per channel."));
    refuseIf(is16Bit(arguments) && !io::takes(file, Bits16), "--bits 16",
             tr("%1 have 8 bits per channel.").arg(namedSuffixes(isFlat, tr("and"))));
}

// Refuses options that make no sense for the format, whatever the entry. Nothing is ignored silently.
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

} // namespace cli
