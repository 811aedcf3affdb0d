// SPDX-License-Identifier: MIT
#include "animation/paths/look_path.h"

#include "attractor/arithmetic/arithmetic.h"
#include "attractor/colour/oklab.h"
#include "attractor/colour/srgb_transfer.h"
#include "attractor/request/appearance_fields.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace animation {

namespace {

using attractor::AppearanceNumber, attractor::LinearColour, attractor::Oklab, attractor::Palette,
    attractor::Rgba;
using attractor::colourOf, attractor::oklab;
using attractor::SpaceAppearance, attractor::SpaceClip;

Rgba mixed(const LinearColour& from, const LinearColour& to, double share) {
    const Oklab a = oklab(from), b = oklab(to);
    const auto mix = [share](double x, double y) { return (1 - share) * x + share * y; };
    return colourOf({mix(a.lightness, b.lightness), mix(a.a, b.a), mix(a.b, b.b), mix(a.alpha, b.alpha)});
}

Rgba mixed(const Rgba& from, const Rgba& to, double share) {
    return from == to ? from : mixed(attractor::linearColour(from), attractor::linearColour(to), share);
}

Palette mixed(const Palette& from, const Palette& to, double share) {
    if (from.stops == to.stops) return from;
    std::vector<double> positions;
    for (const Palette* palette : {&from, &to})
        for (const auto& stop : palette->stops)
            positions.push_back(stop.position);
    std::ranges::sort(positions);
    positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
    Palette palette{from.name, {}};
    for (const double position : positions)
        palette.stops.push_back({position, mixed(attractor::linearColourAt(from, position),
                                                 attractor::linearColourAt(to, position), share)});
    return palette;
}

double byFactor(double from, double to, double share) {
    return from == to ? from
                      : attractor::exponential((1 - share) * attractor::naturalLogarithm(from) +
                                               share * attractor::naturalLogarithm(to));
}

double evenly(double from, double to, double share) {
    return from == to ? from : (1 - share) * from + share * to;
}

// Mixes two slices, or two half-spaces on the same side; returns the first of any other pair.
SpaceClip mixed(const SpaceClip& from, const SpaceClip& to, double share) {
    if (std::isfinite(from.lowest) != std::isfinite(to.lowest) ||
        std::isfinite(from.highest) != std::isfinite(to.highest))
        return from;
    SpaceClip clip{from.normal, evenly(from.lowest, to.lowest, share),
                   evenly(from.highest, to.highest, share)};
    for (int i = 0; i < 3; ++i)
        clip.normal[i] = evenly(from.normal[i], to.normal[i], share);
    return isUsable(clip) ? clip : from;
}

std::optional<SpaceAppearance> mixed(const std::optional<SpaceAppearance>& from,
                                     const std::optional<SpaceAppearance>& to, double share) {
    if (!from || !to) return from;
    SpaceAppearance result = *from;
    result.lightAzimuth += share * std::remainder(to->lightAzimuth - from->lightAzimuth, 360);
    result.lightElevation = evenly(from->lightElevation, to->lightElevation, share);
    result.fog = evenly(from->fog, to->fog, share);
    if (from->clip && to->clip) result.clip = mixed(*from->clip, *to->clip, share);
    return result;
}

} // namespace

Look lookOf(const attractor::Appearance& appearance,
            const std::optional<attractor::SpaceAppearance>& inSpace) {
    const Look usual;
    Look look{appearance, inSpace};
    look.mapColours = usual.mapColours;
    look.mapBlends = usual.mapBlends;
    look.supersample = usual.supersample;
    return look;
}

attractor::Appearance withLook(attractor::Appearance appearance, const Look& look) {
    attractor::Appearance result = look;
    result.mapColours = std::move(appearance.mapColours);
    result.mapBlends = std::move(appearance.mapBlends);
    result.supersample = appearance.supersample;
    return result;
}

Look between(const Look& from, const Look& to, double share) {
    if (share <= 0) return from;
    if (share >= 1) return to;
    Look look = from;
    look.palette = mixed(from.palette, to.palette, share);
    for (const auto& [key, colour] : attractor::appearanceColours)
        look.*colour = mixed(from.*colour, to.*colour, share);
    for (const AppearanceNumber& number : attractor::appearanceNumbers) {
        const auto way = number.scale == AppearanceNumber::Scale::Factor ? byFactor : evenly;
        look.*number.member = way(from.*number.member, to.*number.member, share);
    }
    look.inSpace = mixed(from.inSpace, to.inSpace, share);
    return look;
}

Palette cycled(const Palette& palette, double share) {
    if (share == 0) return palette;
    // Position p shows the colour at |p + 2·share| reflected into 0 … 1.
    const double shift = 2 * share;
    const auto reflected = [](double x) {
        const double rest = x - 2 * std::floor(x / 2);
        return std::min(rest, 2 - rest);
    };
    std::vector<double> positions{0, 1};
    for (const auto& stop : palette.stops)
        for (const double image :
             {stop.position, -stop.position, 2 - stop.position, 2 + stop.position, 4 - stop.position})
            if (const double at = image - shift; at > 0 && at < 1) positions.push_back(at);
    std::ranges::sort(positions);
    positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
    Palette result{palette.name, {}};
    for (const double position : positions)
        result.stops.push_back({position, attractor::colourAt(palette, reflected(position + shift))});
    return result;
}

} // namespace animation
