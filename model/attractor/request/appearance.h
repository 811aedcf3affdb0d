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
    Density, // palette, indexed by the tone of the density
    Map,     // colour of the last map applied
    Address, // palette, indexed by the address coordinate Σ σ_k N^−k
    Plain,   // one colour; its opacity is the tone
    Blend,   // palette, indexed by a coordinate that each map pulls towards its own, as in flames
};

bool coloursSamples(ColourBy colourBy); // true if every sample has a colour of its own

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
    MapColours mapColours; // maps not listed take categoricalColour(index in the system)
    MapBlends mapBlends;   // maps not listed take usualBlend(index in the system, its maps)
    Rgba plain{235, 235, 235, 255};
    Rgba background{13, 16, 23, 255}; // alpha 0: transparent
    double brightness = 20;           // κ, > 0
    double gamma = 2.2;               // > 0
    double contrast = 1;              // > 0; above 1, light and dark move away from the middle
    double vibrancy = 1; // 0 … 1; below 1, the gamma acts partly on single channels, and colours turn paler
    double shadow = 0;   // 0 … 1, opacity of the shadow on the ground; 0: none
    double shadowLean = 0.6;   // distance to the right, and
    double shadowLength = 0.4; // distance up, to the end of the shadow of a point one unit above the ground
    int supersample = 1;       // 1 … 4

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
