// SPDX-License-Identifier: MIT
#include "render/solid_options.h"

#include "options/tr.h"
#include "options/usage_error.h"

#include "document/fractal/space_geometry.h"

namespace cli {

namespace {

using attractor::LookInSpace;
using attractor::SolidColour;

bool usesPalette(SolidColour colour) {
    return colour == SolidColour::Address || colour == SolidColour::Height || colour == SolidColour::Depth;
}

SolidColour colourOf(const document::Fractal& fractal, const RenderArguments& options) {
    if (options.colour) {
        if (options.colour->inSpace) return *options.colour->inSpace;
        throw UsageError{tr("--colour of a solid must be map, address, height, depth or none, not “%1”.")
                             .arg(QString::fromStdString(options.colour->word))};
    }
    const SolidColour stored = document::solidColour(fractal);
    return options.palette && !usesPalette(stored) ? SolidColour::Height : stored;
}

void refuseUnlit(LookInSpace look, const document::Fractal& fractal, const RenderArguments& options) {
    options.given.refuse(Samples | Tone, tr("a solid is not made of samples."));
    if (look == LookInSpace::Ink) options.given.refuse({"--light"}, tr("ink is lit only from the camera."));
    if (look != LookInSpace::Normals) {
        refuseIf(options.palette && !usesPalette(colourOf(fractal, options)), "--palette",
                 tr("it needs --colour address, height or depth."));
        return;
    }
    options.given.refuse(Colours | Cells | Light,
                         tr("--look normals shows directions, without light and colours."));
}

} // namespace

void applySolidOptions(document::Fractal& fractal, const RenderArguments& options) {
    attractor::SpaceAppearance& inSpace = fractal.inSpace;
    refuseUnlit(inSpace.look, fractal, options);
    if (options.background) fractal.appearance.background = *options.background;
    if (inSpace.look == LookInSpace::Normals) return;
    if (options.colour || options.palette) inSpace.colourBy = colourOf(fractal, options);
    if (options.palette) fractal.appearance.palette = *options.palette;
    if (options.light) {
        inSpace.lightAzimuth = options.light->values[0];
        inSpace.lightElevation = options.light->values[1];
    }
    if (options.fog) inSpace.fog = *options.fog;
}

attractor::SolidAppearance solidAppearance(const document::Fractal& fractal, const RenderArguments& options) {
    attractor::SolidAppearance result = document::solidAppearance(fractal);
    if (options.background) result.background = *options.background;
    return result;
}

} // namespace cli
