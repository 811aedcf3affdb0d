// SPDX-License-Identifier: MIT
#include "document/variations/varied_colours.h"

#include "attractor/colour/oklab.h"
#include "attractor/colour/palette_edits.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace document {

namespace {

using attractor::Oklab;
using attractor::Rgba;

Oklab labOf(const Rgba& colour) {
    return attractor::oklab(attractor::linearColour(colour));
}

// Turns the hue by an angle in degrees; greys get a little of a hue.
Rgba turned(const Rgba& colour, double degrees, double tint, Chance& chance) {
    Oklab lab = labOf(colour);
    const double angle = degrees * std::numbers::pi / 180;
    const double a = std::cos(angle) * lab.a - std::sin(angle) * lab.b + tint * chance.normal();
    lab.b = std::sin(angle) * lab.a + std::cos(angle) * lab.b + tint * chance.normal();
    lab.a = a;
    return attractor::nearestShown(lab);
}

// Returns true if both end about as light: a palette for paper would not be seen on black.
bool endAlike(const attractor::Palette& a, const attractor::Palette& b) {
    return std::abs(labOf(a.stops.back().colour).lightness - labOf(b.stops.back().colour).lightness) < 0.25;
}

template <int Dim>
void varyMapColours(attractor::Appearance& appearance, const ifs::IteratedFunctionSystem<Dim>& system,
                    double degrees, double strength, Chance& chance) {
    for (std::size_t i = 0; i < system.maps.size(); ++i) {
        const ifs::MapId id = system.maps[i].id;
        const Rgba before = attractor::mapColour(appearance, id, i);
        appearance.mapColours[id] =
            turned(before, degrees + 60 * strength * chance.normal(), 0.04 * strength, chance);
    }
}

template <int Dim>
void varyMapBlends(attractor::Appearance& appearance, const ifs::IteratedFunctionSystem<Dim>& system,
                   double strength, Chance& chance) {
    for (std::size_t i = 0; i < system.maps.size(); ++i) {
        const ifs::MapId id = system.maps[i].id;
        attractor::MapBlend blend = attractor::mapBlend(appearance, id, i, system.maps.size());
        blend.coordinate = std::clamp(blend.coordinate + 0.4 * strength * chance.normal(), 0.0, 1.0);
        blend.speed = std::clamp(blend.speed + 0.2 * strength * chance.normal(), 0.05, 1.0);
        appearance.mapBlends[id] = blend;
    }
}

template <int Dim>
void varyMaps(attractor::Appearance& appearance, const ifs::IteratedFunctionSystem<Dim>& system,
              double degrees, double strength, Chance& chance) {
    varyMapColours(appearance, system, degrees, strength, chance);
    if (appearance.colourBy == attractor::ColourBy::Blend)
        varyMapBlends(appearance, system, strength, chance);
}

} // namespace

Rgba mixedColour(const Rgba& from, const Rgba& to, double share) {
    if (share <= 0) return from;
    if (share >= 1) return to;
    const Oklab a = labOf(from), b = labOf(to);
    const auto mixed = [&](double x, double y) { return (1 - share) * x + share * y; };
    return attractor::nearestShown(
        {mixed(a.lightness, b.lightness), mixed(a.a, b.a), mixed(a.b, b.b), mixed(a.alpha, b.alpha)});
}

void varyColours(Fractal& fractal, double strength, Chance& chance) {
    attractor::Appearance& appearance = fractal.appearance;
    const double degrees = std::clamp(150 * strength * chance.normal(), -180.0, 180.0);
    const auto palettes = attractor::builtInPalettes();
    const std::size_t other = chance.below(palettes.size());
    const bool takesOther = chance.comes(strength);
    if (takesOther && endAlike(palettes[other], appearance.palette)) appearance.palette = palettes[other];
    attractor::turnHue(appearance.palette, degrees);
    appearance.plain = turned(appearance.plain, degrees, 0.12 * strength, chance);
    if (const System2* system = system2(fractal))
        varyMaps<2>(appearance, *system, degrees, strength, chance);
    else if (const System3* solid = system3(fractal))
        varyMaps<3>(appearance, *solid, degrees, strength, chance);
}

} // namespace document
