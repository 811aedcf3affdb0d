// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/colour/palette.h"
#include "ifs/system/iterated_function_system.h"

#include <utility>
#include <vector>

namespace attractor {

enum class ColourBy {
    Density, // the palette along the tone of the density
    Map,     // the colour of the last map applied
    Address, // the palette along the address coordinate Σ σ_k N^-k
    Plain,   // one colour, the tone is its opacity
};

bool coloursSamples(ColourBy colourBy); // whether every sample has a colour of its own

// Colours that maps have been given. In one piece, because a system is copied at every step of a drag and may
// have 10⁵ maps.
class MapColours {
public:
    const Rgba* find(ifs::MapId id) const; // nullptr: it has been given none
    Rgba& operator[](ifs::MapId id);       // fast when ids grow
    bool empty() const { return m_colours.empty(); }
    void reserve(std::size_t count) { m_colours.reserve(count); }

    // Forgets the colours of the maps for which `isGone(id)`.
    template <typename Predicate> void eraseIf(Predicate isGone) {
        std::erase_if(m_colours, [&](const auto& colour) { return isGone(colour.first); });
    }

    friend bool operator==(const MapColours&, const MapColours&) = default;

private:
    std::vector<std::pair<ifs::MapId, Rgba>> m_colours; // by id
};

// How densities become colours. docs/mathematics.md, "Density to colour".
struct Appearance {
    ColourBy colourBy = ColourBy::Density;
    Palette palette = builtInPalettes().front();
    MapColours mapColours; // maps absent here take categoricalColour(index in the system)
    Rgba plain{235, 235, 235, 255};
    Rgba background{13, 16, 23, 255}; // alpha 0: transparent
    double brightness = 20;           // κ > 0
    double gamma = 2.2;               // > 0
    double contrast = 1;              // > 0; above 1, light and dark part from the middle
    double vibrancy = 1;              // 0 … 1; below 1, the gamma acts in part on each channel, and pales
    int supersample = 1;              // 1 … 4

    friend bool operator==(const Appearance&, const Appearance&) = default;
};

Rgba mapColour(const Appearance& appearance, ifs::MapId id, std::size_t index);

} // namespace attractor
