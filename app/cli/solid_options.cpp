// SPDX-License-Identifier: MIT
#include "solid_options.h"

#include "arguments.h"
#include "usage_error.h"

#include "io/text/number.h"

#include <QCoreApplication>
#include <QStringList>

namespace cli {

namespace {

using attractor::Look;
using attractor::SolidColour;

QString tr(const char* text) {
    return QCoreApplication::translate("cli", text);
}

SolidColour colourOf(const RenderArguments& options) {
    if (!options.colour) return options.palette ? SolidColour::Height : SolidColour::Plain;
    if (*options.colour == "map") return SolidColour::Map;
    if (*options.colour == "height") return SolidColour::Height;
    if (*options.colour == "depth") return SolidColour::Depth;
    if (*options.colour == "none") return SolidColour::Plain;
    throw UsageError{tr("--colour of a solid must be map, height, depth or none, not “%1”.")
                         .arg(QString::fromStdString(*options.colour))};
}

attractor::ViewVector lampOf(const std::string& text) {
    const QStringList parts = QString::fromStdString(text).split(u',');
    if (parts.size() == 2) {
        const auto azimuth = io::parseNumber(parts[0]), elevation = io::parseNumber(parts[1]);
        if (azimuth && elevation) return attractor::lampAt(*azimuth, *elevation);
    }
    throw UsageError{tr("--light “%1” is not valid: it must be azimuth and elevation in degrees from the "
                        "line of sight, such as -40,40.")
                         .arg(QString::fromStdString(text))};
}

double fogOf(const std::string& text) {
    const auto fog = io::parseNumber(QString::fromStdString(text));
    if (fog && *fog >= 0 && *fog <= 100) return *fog;
    throw UsageError{
        tr("--fog “%1” is not valid: it must be a number from 0 to 100.").arg(QString::fromStdString(text))};
}

std::vector<attractor::Rgba> mapColours(const document::Fractal& fractal) {
    std::vector<attractor::Rgba> colours;
    const auto& maps = document::system3(fractal)->maps;
    for (std::size_t i = 0; i < maps.size(); ++i)
        colours.push_back(attractor::mapColour(fractal.appearance, maps[i].id, i));
    return colours;
}

void refuseUnlit(Look look, const RenderArguments& options) {
    const QString solid = tr("a solid is not made of samples.");
    refuseIf(options.points.has_value(), "--points", solid);
    refuseIf(options.gamma.has_value(), "--gamma", solid);
    refuseIf(options.brightness.has_value(), "--brightness", solid);
    if (look == Look::Ink)
        refuseIf(options.light.has_value(), "--light", tr("ink has only the light of the eye."));
    if (look != Look::Normals) {
        const SolidColour colour = colourOf(options);
        refuseIf(options.palette && colour != SolidColour::Height && colour != SolidColour::Depth,
                 "--palette", tr("it needs --colour height or depth."));
        return;
    }
    const QString numbers = tr("--look normals shows directions, without light and colours.");
    refuseIf(options.palette.has_value(), "--palette", numbers);
    refuseIf(options.colour.has_value(), "--colour", numbers);
    refuseIf(options.supersample.has_value(), "--supersample", numbers);
    refuseLight(options, numbers);
}

} // namespace

std::optional<Look> solidLook(const std::string& name) {
    if (name == "stone") return Look::Stone;
    if (name == "ink") return Look::Ink;
    if (name == "normals") return Look::Normals;
    return std::nullopt;
}

attractor::SolidAppearance solidAppearance(Look look, const document::Fractal& fractal,
                                           const RenderArguments& options) {
    refuseUnlit(look, options);
    attractor::SolidAppearance result = attractor::appearanceOf(look);
    if (look == Look::Stone) result.background = fractal.appearance.background;
    if (options.background) result.background = colourArgument("--background", *options.background);
    if (look == Look::Normals) return result;
    result.colourBy = colourOf(options);
    result.palette =
        options.palette ? paletteArgument("--palette", *options.palette) : fractal.appearance.palette;
    result.mapColours = mapColours(fractal);
    if (options.light) result.keyLight = lampOf(*options.light);
    if (options.fog) result.fog = fogOf(*options.fog);
    return result;
}

void refuseLight(const RenderArguments& options, const QString& reason) {
    refuseIf(options.light.has_value(), "--light", reason);
    refuseIf(options.fog.has_value(), "--fog", reason);
}

} // namespace cli
