// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/palette.h"
#include "ifs/iterated_function_system.h"

#include <map>

namespace attractor {

enum class ColourBy {
    Density, // the palette along the tone of the density
    Map,     // the colour of the last map applied
    Address, // the palette along the address coordinate Σ σ_k N^-k
    Plain,   // one colour, the tone is its opacity
};

// How densities become colours. docs/mathematics.md, "Density to colour".
struct Appearance {
    ColourBy colourBy = ColourBy::Density;
    Palette palette = builtInPalettes().front();
    std::map<ifs::MapId, Rgba> mapColours; // maps absent here take categoricalColour(place in the system)
    Rgba plain{235, 235, 235, 255};
    Rgba background{13, 16, 23, 255}; // alpha 0: transparent
    double brightness = 20;           // κ > 0
    double gamma = 2.2;               // > 0
    int supersample = 1;              // 1 … 4

    friend bool operator==(const Appearance&, const Appearance&) = default;
};

Rgba mapColour(const Appearance& appearance, ifs::MapId id, std::size_t place);

} // namespace attractor
