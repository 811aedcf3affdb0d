// SPDX-License-Identifier: MIT
#include "render/solid_options.h"

#include "options/tr.h"
#include "options/usage_error.h"
#include "process/arguments.h"

#include "document/fractal/space_geometry.h"
#include "io/fractint/space_comments.h"
#include "io/text/number.h"

namespace cli {

namespace {

using attractor::LookInSpace;
using attractor::SolidColour;

bool usesPalette(SolidColour colour) {
    return colour == SolidColour::Address || colour == SolidColour::Height || colour == SolidColour::Depth;
}

SolidColour colourOf(const document::Fractal& fractal, const RenderArguments& options) {
    if (options.colour) {
        if (const auto colour = io::solidColourNamed(QByteArray::fromStdString(*options.colour)))
            return *colour;
        throw UsageError{tr("--colour of a solid must be map, address, height, depth or none, not “%1”.")
                             .arg(QString::fromStdString(*options.colour))};
    }
    const SolidColour stored = document::solidColour(fractal);
    return options.palette && !usesPalette(stored) ? SolidColour::Height : stored;
}

void applyLight(attractor::SpaceAppearance& appearance, const std::string& text) {
    const std::vector<double> angles = numbers(QString::fromStdString(text));
    if (angles.size() != 2)
        throw UsageError{tr("--light “%1” is not valid: it must be azimuth and elevation in degrees from the "
                            "line of sight, such as -40,40.")
                             .arg(QString::fromStdString(text))};
    appearance.lightAzimuth = angles[0];
    appearance.lightElevation = angles[1];
}

double fogOf(const std::string& text) {
    const auto fog = io::parseNumber(QString::fromStdString(text));
    if (fog && *fog >= 0 && *fog <= 100) return *fog;
    throw UsageError{
        tr("--fog “%1” is not valid: it must be a number from 0 to 100.").arg(QString::fromStdString(text))};
}

void refuseUnlit(LookInSpace look, const document::Fractal& fractal, const RenderArguments& options) {
    const QString solid = tr("a solid is not made of samples.");
    refuseIf(options.points.has_value(), "--points", solid);
    refuseIf(options.gamma.has_value(), "--gamma", solid);
    refuseIf(options.brightness.has_value(), "--brightness", solid);
    refuseIf(options.contrast.has_value(), "--contrast", solid);
    refuseIf(options.vibrancy.has_value(), "--vibrancy", solid);
    if (look == LookInSpace::Ink)
        refuseIf(options.light.has_value(), "--light", tr("ink is lit only from the camera."));
    if (look != LookInSpace::Normals) {
        refuseIf(options.palette && !usesPalette(colourOf(fractal, options)), "--palette",
                 tr("it needs --colour address, height or depth."));
        return;
    }
    const QString numbers = tr("--look normals shows directions, without light and colours.");
    refuseIf(options.palette.has_value(), "--palette", numbers);
    refuseIf(options.colour.has_value(), "--colour", numbers);
    refuseIf(options.supersample.has_value(), "--supersample", numbers);
    refuseLight(options, numbers);
}

} // namespace

void applySolidOptions(document::Fractal& fractal, const RenderArguments& options) {
    attractor::SpaceAppearance& inSpace = fractal.inSpace;
    refuseUnlit(inSpace.look, fractal, options);
    if (options.background)
        fractal.appearance.background = colourArgument("--background", *options.background);
    if (inSpace.look == LookInSpace::Normals) return;
    if (options.colour || options.palette) inSpace.colourBy = colourOf(fractal, options);
    if (options.readPalette) fractal.appearance.palette = *options.readPalette;
    if (options.light) applyLight(inSpace, *options.light);
    if (options.fog) inSpace.fog = fogOf(*options.fog);
}

attractor::SolidAppearance solidAppearance(const document::Fractal& fractal, const RenderArguments& options) {
    attractor::SolidAppearance result = document::solidAppearance(fractal);
    if (options.background) result.background = colourArgument("--background", *options.background);
    return result;
}

void refuseLight(const RenderArguments& options, const QString& reason) {
    refuseIf(options.light.has_value(), "--light", reason);
    refuseIf(options.fog.has_value(), "--fog", reason);
}

} // namespace cli
