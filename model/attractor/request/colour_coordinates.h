// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/appearance.h"

#include <cstddef>
#include <span>
#include <vector>

namespace attractor {

// The part of the palette that the points of a word lie in: c(w_σ(x)) = start + width·c(x).
struct PaletteInterval {
    double start = 0;
    double width = 1;
};

// Palette coordinates along addresses: c(w_i(x)) from c(x) for each map that takes part. docs/mathematics.md,
// "Density to colour".
class ColourCoordinates {
public:
    ColourCoordinates() = default; // no maps
    // Coordinates along the address: (i + c)/N.
    explicit ColourCoordinates(std::size_t maps) : m_maps(maps) {}
    // (1 − s_i)·c + s_i·c_i, with one blend and one probability for each map.
    ColourCoordinates(std::vector<MapBlend> blends, std::span<const double> probabilities);

    bool empty() const { return m_maps == 0; }
    double beginning() const { return m_blends.empty() ? 0 : m_mean; } // start value of an orbit

    double next(std::size_t map, double c) const {
        if (m_blends.empty()) return (static_cast<double>(map) + c) / static_cast<double>(m_maps);
        return (1 - m_blends[map].speed) * c + m_blends[map].speed * m_blends[map].coordinate;
    }
    // The interval of the word with this map as its new innermost one.
    PaletteInterval child(const PaletteInterval& word, std::size_t map) const {
        if (m_blends.empty()) {
            const double width = word.width / static_cast<double>(m_maps);
            return {word.start + static_cast<double>(map) * width, width};
        }
        const MapBlend& blend = m_blends[map];
        return {word.start + word.width * blend.speed * blend.coordinate, word.width * (1 - blend.speed)};
    }
    // The palette coordinate used for all points of a word: the middle of the interval, or with blends the
    // mean over the points.
    double middle(const PaletteInterval& word) const { return word.start + word.width * m_mean; }

    // Returns true if a word has to be divided because its points differ in colour; never along the address,
    // where the minimum length of words takes care of that.
    bool isMixed(const PaletteInterval& word) const { return word.width * m_range > maxRange; }
    // The share of the measure in view above which a word is divided.
    double minShare() const { return static_cast<double>(m_maps) / words; }

private:
    static constexpr double maxRange = 1.0 / 64;
    static constexpr double words = 1U << 15; // most words that colours may cost

    std::size_t m_maps = 0;
    std::vector<MapBlend> m_blends; // empty: colours along the address
    double m_mean = 0.5;            // mean of c over the measure
    double m_range = 0;             // range of c over the attractor
};

// The blend by which the map at `index` among `maps` leads along the address.
MapBlend addressBlend(std::size_t index, std::size_t maps);

// The coordinates that the appearance asks for; along the address if it colours by something else. `active`
// belongs to the system.
template <int Dim>
ColourCoordinates colourCoordinates(const Appearance& appearance,
                                    const ifs::IteratedFunctionSystem<Dim>& system,
                                    const ifs::ActiveMaps<Dim>& active);

} // namespace attractor
