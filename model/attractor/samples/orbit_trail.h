// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/samples/chaos_game.h"
#include "attractor/samples/prepared_system.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace attractor {

// The last points of the chaos game that Algorithm::ChaosGame plots with the same system and seed.
class OrbitTrail {
public:
    static constexpr std::size_t longest = 8;

    struct Point {
        ifs::Vector<2> x;    // coordinates of the code
        std::size_t map = 0; // the last one applied: its index in the system
    };

    OrbitTrail(PreparedSystem system, std::uint64_t seed);

    // The newest of the first `plotted` points, the oldest of them first. Costs the points since the last
    // call, or all of them when they are fewer than then.
    const std::vector<Point>& after(std::uint64_t plotted);

private:
    PreparedSystem m_system;
    std::uint64_t m_seed;
    std::unique_ptr<Orbit> m_orbit; // none where nothing can be drawn
    std::uint64_t m_plotted = 0;
    std::vector<Point> m_points;
};

} // namespace attractor
