// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/colour_coordinates.h"
#include "attractor/samples/chaos_game.h"
#include "attractor/samples/prepared_space.h"

#include <cstdint>

namespace attractor {

// The chaos game in space: one orbit from a fixed point of the first map (or the origin) of which the first
// Orbit::skipped points are not plotted. An orbit that escapes begins anew.
class SpaceOrbit {
public:
    SpaceOrbit(const PreparedSpace& system, std::uint64_t seed,
               ColourCoordinates colours = {}); // empty: colours along the address

    struct Point {
        ifs::Vector<3> x = ifs::Vector<3>::Zero();
        std::uint32_t lastMap = 0;    // index among the maps that take part
        double addressCoordinate = 0; // Σ σ_k N^−k, newest map first
        double colourCoordinate = 0;
    };
    const Point& next(); // next point to plot

private:
    const PreparedSpace* m_system; // must outlive the orbit
    ColourCoordinates m_colours;
    AliasTable m_table;
    Point m_point;
    double m_farAway = 0;
    std::uint64_t m_random = 0;
};

} // namespace attractor
