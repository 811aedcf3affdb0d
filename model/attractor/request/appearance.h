// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/colour/palette.h"
#include "attractor/request/map_values.h"
#include "ifs/names.h"
#include "ifs/system/iterated_function_system.h"

#include <array>
#include <cstddef>

namespace attractor {

enum class ColourBy {
    Density, // the palette along the tone of the density
    Map,     // the colour of the last map applied
    Address, // the palette along the address coordinate Σ σ_k N^-k
    Plain,   // one colour, the tone is its opacity
    Blend,   // the palette along the coordinate that every map pulls to its own, as in flames
};

bool coloursSamples(ColourBy colourBy); // whether every sample has a colour of its own

// Colours that maps have been given.
using MapColours = MapValues<Rgba>;

// The effect of a map on palette coordinates: c becomes (1 − speed)·c + speed·coordinate.
struct MapBlend {
    double coordinate = 0; // 0 … 1
    double speed = 0.5;    // 0 … 1

    friend bool operator==(const MapBlend&, const MapBlend&) = default;
};
using MapBlends = MapValues<MapBlend>;

// Settings that turn densities into colours. docs/mathematics.md, "Density to colour".
struct Appearance {
    // Defined in one source, because many files copy appearances.
    Appearance();
    Appearance(const Appearance& other);
    Appearance(Appearance&& other) noexcept;
    Appearance& operator=(const Appearance& other);
    Appearance& operator=(Appearance&& other) noexcept;
    ~Appearance();

    ColourBy colourBy = ColourBy::Density;
    Palette palette = builtInPalettes().front();
    MapColours mapColours; // maps absent here take categoricalColour(index in the system)
    MapBlends mapBlends;   // maps absent here take usualBlend(index in the system, its maps)
    Rgba plain{235, 235, 235, 255};
    Rgba background{13, 16, 23, 255}; // alpha 0: transparent
    double brightness = 20;           // κ > 0
    double gamma = 2.2;               // > 0
    double contrast = 1;              // > 0; above 1, light and dark part from the middle
    double vibrancy = 1;              // 0 … 1; below 1, the gamma acts in part on each channel, and pales
    double shadow = 0;                // 0 … 1, opacity of the shadow on the ground; 0: none
    double shadowLean = 0.6;          // how far to the right, and
    double shadowLength = 0.4;        // how far up, the shadow of what stands one unit above the ground ends
    int supersample = 1;              // 1 … 4

    friend bool operator==(const Appearance&, const Appearance&) = default;
};

Rgba mapColour(const Appearance& appearance, ifs::MapId id, std::size_t index);

// Default blends: coordinates at even distances along the palette, speed one half.
MapBlend usualBlend(std::size_t index, std::size_t maps);
// The blend of the map at `index` among `maps` maps.
MapBlend mapBlend(const Appearance& appearance, ifs::MapId id, std::size_t index, std::size_t maps);
// The composition of two blends, `outer` after `inner`.
MapBlend composed(const MapBlend& outer, const MapBlend& inner);

} // namespace attractor

template <>
inline constexpr auto ifs::names<attractor::ColourBy> = std::to_array<ifs::Named<attractor::ColourBy>>({
    {attractor::ColourBy::Density, "density"},
    {attractor::ColourBy::Map, "map"},
    {attractor::ColourBy::Address, "address"},
    {attractor::ColourBy::Plain, "plain"},
    {attractor::ColourBy::Blend, "blend"},
});
