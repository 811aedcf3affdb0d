// SPDX-License-Identifier: MIT
#include "animation/look_path.h"

#include "attractor/arithmetic/arithmetic.h"
#include "attractor/colour/srgb_transfer.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace animation {

namespace {

using attractor::LinearColour, attractor::Palette, attractor::Rgba;

// Björn Ottosson, A perceptual color space for image processing (2020).
struct Oklab {
    double lightness, a, b, alpha;
};

double cubeRoot(double x) {
    return x > 0 ? attractor::power(x, 1.0 / 3) : 0;
}

Oklab oklab(const LinearColour& c) {
    const double l = cubeRoot(0.4122214708 * c.red + 0.5363325363 * c.green + 0.0514459929 * c.blue);
    const double m = cubeRoot(0.2119034982 * c.red + 0.6806995451 * c.green + 0.1073969566 * c.blue);
    const double s = cubeRoot(0.0883024619 * c.red + 0.2817188376 * c.green + 0.6299787005 * c.blue);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s, c.alpha};
}

Rgba colourOf(const Oklab& lab) {
    const auto cube = [](double x) { return x * x * x; };
    const double l = cube(lab.lightness + 0.3963377774 * lab.a + 0.2158037573 * lab.b);
    const double m = cube(lab.lightness - 0.1055613458 * lab.a - 0.0638541728 * lab.b);
    const double s = cube(lab.lightness - 0.0894841775 * lab.a - 1.2914855480 * lab.b);
    const auto channel = [](double light) { return attractor::encoded(std::clamp(light, 0.0, 1.0)); };
    return {channel(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            channel(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            channel(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s),
            std::uint8_t(std::clamp(lab.alpha * 255 + 0.5, 0.0, 255.0))};
}

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
    positions.erase(std::ranges::unique(positions).begin(), positions.end());
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

} // namespace

Look lookOf(const attractor::Appearance& appearance) {
    return {appearance.colourBy,   appearance.palette,    appearance.plain,
            appearance.background, appearance.brightness, appearance.gamma};
}

attractor::Appearance withLook(attractor::Appearance appearance, const Look& look) {
    appearance.colourBy = look.colourBy;
    appearance.palette = look.palette;
    appearance.plain = look.plain;
    appearance.background = look.background;
    appearance.brightness = look.brightness;
    appearance.gamma = look.gamma;
    return appearance;
}

Look between(const Look& from, const Look& to, double share) {
    if (share <= 0) return from;
    if (share >= 1) return to;
    return {from.colourBy,
            mixed(from.palette, to.palette, share),
            mixed(from.plain, to.plain, share),
            mixed(from.background, to.background, share),
            byFactor(from.brightness, to.brightness, share),
            byFactor(from.gamma, to.gamma, share)};
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
    positions.erase(std::ranges::unique(positions).begin(), positions.end());
    Palette result{palette.name, {}};
    for (const double position : positions)
        result.stops.push_back({position, attractor::colourAt(palette, reflected(position + shift))});
    return result;
}

} // namespace animation
