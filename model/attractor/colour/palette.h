// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace attractor {

// sRGB, 8 bits per channel, not premultiplied.
struct Rgba {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
    std::uint8_t alpha = 255;

    friend bool operator==(const Rgba&, const Rgba&) = default;
};

// A gradient over [0, 1]; stops in order of position, the first at 0, the last at 1, interpolated in linear
// light.
struct Palette {
    struct Stop {
        double position = 0;
        Rgba colour;
        friend bool operator==(const Stop&, const Stop&) = default;
    };
    std::string name; // English; shown translated
    std::vector<Stop> stops;

    friend bool operator==(const Palette&, const Palette&) = default;
};

Rgba colourAt(const Palette& palette, double position);

// Linear light and opacity, 0 … 1, unrounded.
struct LinearColour {
    double red = 0;
    double green = 0;
    double blue = 0;
    double alpha = 1;
};
LinearColour linearColour(const Rgba& colour);
LinearColour linearColourAt(const Palette& palette, double position); // result of colourAt() before rounding

// The palettes that come with the program; the first is the default. Perceptually even, light and dark ones.
std::span<const Palette> builtInPalettes();
const Palette* findPalette(std::string_view name); // ignores case; nullptr if there is none

// Colours for map 0, 1, 2 …: distinct for neighbours, readable on black and on white; repeats after a while.
Rgba categoricalColour(std::size_t index);

} // namespace attractor
