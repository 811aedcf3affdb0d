// SPDX-License-Identifier: MIT
#include "attractor/colour/oklab.h"

#include "attractor/arithmetic/arithmetic.h"
#include "attractor/colour/srgb_transfer.h"

#include <algorithm>
#include <cstdint>

namespace attractor {

namespace {

double cubeRoot(double x) {
    return x > 0 ? power(x, 1.0 / 3) : 0;
}

bool isShown(const Oklab& lab) {
    constexpr double slack = 1e-4; // less than a level
    const LinearColour light = lightOf(lab);
    const auto fits = [](double x) { return x >= -slack && x <= 1 + slack; };
    return fits(light.red) && fits(light.green) && fits(light.blue);
}

} // namespace

Oklab oklab(const LinearColour& c) {
    const double l = cubeRoot(0.4122214708 * c.red + 0.5363325363 * c.green + 0.0514459929 * c.blue);
    const double m = cubeRoot(0.2119034982 * c.red + 0.6806995451 * c.green + 0.1073969566 * c.blue);
    const double s = cubeRoot(0.0883024619 * c.red + 0.2817188376 * c.green + 0.6299787005 * c.blue);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s, c.alpha};
}

LinearColour lightOf(const Oklab& lab) {
    const auto cube = [](double x) { return x * x * x; };
    const double l = cube(lab.lightness + 0.3963377774 * lab.a + 0.2158037573 * lab.b);
    const double m = cube(lab.lightness - 0.1055613458 * lab.a - 0.0638541728 * lab.b);
    const double s = cube(lab.lightness - 0.0894841775 * lab.a - 1.2914855480 * lab.b);
    return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s, lab.alpha};
}

Rgba colourOf(const Oklab& lab) {
    const LinearColour light = lightOf(lab);
    const auto channel = [](double value) { return encoded(std::clamp(value, 0.0, 1.0)); };
    return {channel(light.red), channel(light.green), channel(light.blue),
            std::uint8_t(std::clamp(lab.alpha * 255 + 0.5, 0.0, 255.0))};
}

Rgba nearestShown(const Oklab& lab) {
    if (isShown(lab)) return colourOf(lab);
    const auto duller = [&lab](double share) {
        return Oklab{lab.lightness, share * lab.a, share * lab.b, lab.alpha};
    };
    double low = 0;
    double high = 1;
    for (int step = 0; step < 24; ++step) {
        const double middle = (low + high) / 2;
        (isShown(duller(middle)) ? low : high) = middle;
    }
    return colourOf(duller(low));
}

} // namespace attractor
