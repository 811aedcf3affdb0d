// SPDX-License-Identifier: MIT
#include "attractor/colour/palette_library.h"

#include "attractor/arithmetic/arithmetic.h"
#include "attractor/colour/oklab.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace attractor {

namespace {

// Names of the hues at multiples of 15° in Oklab.
constexpr std::array<std::string_view, 24> hues{
    "Rose",  "Crimson", "Scarlet",  "Vermilion", "Orange", "Amber",  "Gold",    "Lemon",
    "Lime",  "Grass",   "Emerald",  "Jade",      "Teal",   "Sea",    "Cyan",    "Sky",
    "Azure", "Cobalt",  "Sapphire", "Indigo",    "Violet", "Purple", "Magenta", "Fuchsia"};
constexpr int hueCount = static_cast<int>(hues.size());
constexpr double hueStep = 360.0 / hueCount;

struct Tone {
    double lightness;
    double chroma;
    double hue; // degrees
};

Rgba shown(const Tone& tone) {
    return nearestShown(
        {tone.lightness, tone.chroma * cosineOfDegrees(tone.hue), tone.chroma * sineOfDegrees(tone.hue), 1});
}

double between(double a, double b, double f) {
    return a + (b - a) * f;
}

// The smaller turn that leads from one hue to the other, −180° … 180°.
double turn(double from, double to) {
    return std::remainder(to - from, 360.0);
}

using Stops = std::vector<Palette::Stop>;

// Seventeen tones, evenly spaced.
Stops ramp(auto toneAt) {
    constexpr int last = 16;
    Stops stops;
    for (int i = 0; i <= last; ++i) {
        const double u = static_cast<double>(i) / last;
        stops.push_back({u, shown(toneAt(u))});
    }
    return stops;
}

// The bump of chroma in the middle of a ramp: dark and light tones cannot be as colourful.
double arch(double u) {
    return 4 * u * (1 - u);
}

// Like embers: the hue turns towards yellow as it brightens.
Stops glow(double hue, double) {
    const double warm = std::clamp(turn(hue, 100), -48.0, 48.0);
    return ramp([&](double u) {
        return Tone{between(0.38, 0.98, u), 0.06 + 0.15 * arch(0.15 + 0.75 * u), hue + warm * u * u};
    });
}

Stops ink(double hue, double) {
    return ramp([&](double u) { return Tone{between(0.76, 0.2, u), between(0.13, 0.06, u), hue}; });
}

// Through the hues that lie between the two.
Stops blend(double hue, double other) {
    const double way = turn(hue, other);
    return ramp([&](double u) {
        return Tone{between(0.4, 0.96, u), 0.08 + 0.12 * arch(0.2 + 0.6 * u), hue + way * u};
    });
}

// Straight from one hue to the other, by way of a grey.
Stops contrast(double hue, double other) {
    return ramp([&](double u) {
        const double side = 1 - 2 * u;
        return Tone{between(0.42, 0.9, u), 0.17 * std::abs(side) + 0.02, side > 0 ? hue : other};
    });
}

// Pale in the middle, dark at both ends.
Stops diverging(double hue, double other) {
    return ramp([&](double u) {
        const double side = std::abs(1 - 2 * u);
        return Tone{between(0.97, 0.38, side), 0.01 + 0.15 * arch(0.1 + 0.55 * side), u < 0.5 ? hue : other};
    });
}

// Dark, light and dark again, so that its end meets its beginning.
Stops twilight(double hue, double other) {
    return ramp([&](double u) {
        const double light = 0.5 - 0.5 * cosineOfDegrees(360 * u);
        return Tone{between(0.28, 0.93, light), 0.04 + 0.11 * arch(light), u < 0.5 ? hue : other};
    });
}

// Most of the circle of hues, while it brightens.
Stops spectrum(double hue, double) {
    return ramp([&](double u) { return Tone{between(0.36, 0.95, u), 0.07 + 0.1 * arch(u), hue + 300 * u}; });
}

// The whole circle of hues at one lightness; its end meets its beginning.
Stops wheel(double hue, double) {
    return ramp([&](double u) { return Tone{0.76, 0.125, hue + 360 * u}; });
}

Stops pastel(double hue, double other) {
    const double way = turn(hue, other);
    return ramp([&](double u) {
        return Tone{between(0.74, 0.97, u), between(0.1, 0.035, u), hue + way * u};
    });
}

// The sheen of brushed metal.
Stops metal(double hue, double) {
    return ramp([&](double u) {
        const double sheen = 0.09 * sineOfDegrees(720 * u);
        return Tone{between(0.34, 0.96, u) + sheen * (1 - u), 0.035, hue};
    });
}

// Five ramps one after another, each brighter than the one before.
Stops bands(double hue, double) {
    constexpr int count = 5;
    Stops stops;
    for (int band = 0; band < count; ++band)
        for (const double u : {0.0, 0.5, 1.0}) {
            const double rise = static_cast<double>(band) / (count - 1);
            stops.push_back({(band + u) / count,
                             shown({between(0.3, 0.62, rise) + 0.34 * u, 0.15, hue + 40 * rise + 20 * u})});
        }
    return stops;
}

struct Recipe {
    std::string_view pattern;
    Stops (*make)(double hue, double other);
    int every;      // steps of 15° between two palettes
    int otherSteps; // steps of 15° from the hue to the other hue
};

constexpr std::array recipes{Recipe{"%1 Glow", glow, 1, 0},         Recipe{"%1 to %2", blend, 1, 6},
                             Recipe{"%1 into %2", contrast, 1, 10}, Recipe{"%1 Spectrum", spectrum, 1, 0},
                             Recipe{"%1 Pastel", pastel, 1, 4},     Recipe{"%1 Metal", metal, 1, 0},
                             Recipe{"%1 Bands", bands, 1, 0},       Recipe{"%1 Ink", ink, 1, 0},
                             Recipe{"%1 and %2", diverging, 2, 12}, Recipe{"%1 Twilight", twilight, 2, 3},
                             Recipe{"%1 Wheel", wheel, 4, 0}};

std::string nameOf(const LibraryPalette& made) {
    std::string name(made.pattern);
    for (const auto& [mark, hue] : {std::pair(std::string_view("%1"), made.hue), {"%2", made.otherHue}})
        if (const std::size_t at = name.find(mark); at != std::string::npos)
            name.replace(at, mark.size(), hue);
    return name;
}

std::vector<LibraryPalette> made() {
    std::vector<LibraryPalette> library;
    for (const Recipe& recipe : recipes)
        for (int i = 0; i < hueCount; i += recipe.every) {
            const int other = (i + recipe.otherSteps) % hueCount;
            const bool hasTwo = recipe.pattern.find("%2") != std::string_view::npos;
            LibraryPalette palette{{},
                                   recipe.pattern,
                                   hues[static_cast<std::size_t>(i)],
                                   hasTwo ? hues[static_cast<std::size_t>(other)] : std::string_view()};
            palette.palette = {nameOf(palette), recipe.make(hueStep * i, hueStep * other)};
            library.push_back(std::move(palette));
        }
    return library;
}

bool isSameLetter(char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

} // namespace

std::span<const LibraryPalette> paletteLibrary() {
    static const std::vector<LibraryPalette> library = made();
    return library;
}

const Palette* findInLibrary(std::string_view name) {
    for (const LibraryPalette& entry : paletteLibrary())
        if (std::ranges::equal(entry.palette.name, name, isSameLetter)) return &entry.palette;
    return nullptr;
}

} // namespace attractor
