// SPDX-License-Identifier: MIT
#include "attractor/light/solid_ramp.h"

#include "attractor/colour/srgb_transfer.h"

#include <algorithm>
#include <array>

namespace attractor {

namespace {

constexpr int plainLevels = 1024;
constexpr int tintedLevels = 256;
constexpr double exposure = 1.35; // makes a surface between eye and key light about as bright as its tint
constexpr double wash = 0.78;
constexpr double fullLight = 4095;

LinearColour tint(const SolidAppearance& appearance, int index) {
    const auto at = static_cast<std::size_t>(index);
    switch (appearance.colourBy) {
    case SolidColour::Plain:
        break;
    case SolidColour::Map:
        return linearColour(at < appearance.mapColours.size() ? appearance.mapColours[at]
                                                              : categoricalColour(at));
    case SolidColour::Address:
    case SolidColour::Height:
    case SolidColour::Depth:
        return linearColourAt(appearance.palette, index / (tintCount - 1.0));
    }
    return linearColour(appearance.plain);
}

// The colour of stone: warm where the lamp falls on it, that of the sky in the shade.
LinearColour stone(const LinearColour& tint, double light) {
    const auto lamp = [&](double sky, double sun) { return exposure * light * (sky + (sun - sky) * light); };
    return {tint.red * lamp(0.66, 1.08), tint.green * lamp(0.84, 1.02), tint.blue * lamp(1.24, 0.9)};
}

// The ramp from the ink of the tint to a light wash, which stands out from white paper.
LinearColour ink(const LinearColour& tint, double light) {
    const auto paper = [&](double channel) { return channel + (1 - channel) * wash * light; };
    return {paper(tint.red), paper(tint.green), paper(tint.blue)};
}

std::uint32_t code(double linear) { // sRGB code of 12-bit light
    static const auto codes = [] {
        std::array<std::uint8_t, 4096> table{};
        for (std::size_t i = 0; i < table.size(); ++i)
            table[i] = encoded(static_cast<double>(i) / fullLight);
        return table;
    }();
    return codes[static_cast<std::size_t>(std::clamp(linear, 0.0, 1.0) * fullLight + 0.5)];
}

} // namespace

LinearColour litColour(Look look, const LinearColour& tint, double light) {
    return look == Look::Ink ? ink(tint, light) : stone(tint, light);
}

SolidRamp solidRamp(const SolidAppearance& appearance) {
    const bool plain = appearance.colourBy == SolidColour::Plain;
    SolidRamp ramp;
    ramp.levels = plain ? plainLevels : tintedLevels;
    for (int index = 0; index < (plain ? 1 : tintCount); ++index) {
        ramp.tints.push_back(tint(appearance, index));
        for (int level = 0; level < ramp.levels; ++level) {
            const LinearColour colour =
                litColour(appearance.look, ramp.tints.back(), level / (ramp.levels - 1.0));
            ramp.pixels.push_back(0xFF000000U | code(colour.red) << 16 | code(colour.green) << 8 |
                                  code(colour.blue));
        }
    }
    return ramp;
}

} // namespace attractor
