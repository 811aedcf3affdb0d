// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/samples/chaos_game.h"
#include "attractor/samples/prepared_system.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace attractor {

// The last jumps of the chaos game that Algorithm::ChaosGame plots with the same system and seed, from the
// first one on: the first Orbit::skipped points are those that it does not plot.
class OrbitTrail {
public:
    static constexpr std::size_t longest = 4096;

    struct Point {
        ifs::Vector<2> x;    // coordinates of the code
        std::size_t map = 0; // index in the system of the last map applied
    };

    OrbitTrail(PreparedSystem system, std::uint64_t seed);

    // The last points of the first `jumps` jumps, at most `longest`, oldest first; valid until the next call.
    // Costs the jumps since the last call, or all of them if the number has decreased.
    std::span<const Point> after(std::uint64_t jumps);

private:
    PreparedSystem m_system;
    std::uint64_t m_seed;
    std::unique_ptr<Orbit> m_orbit; // null if nothing can be drawn
    std::uint64_t m_jumps = 0;
    std::vector<Point> m_points; // newest last; at least `longest` points once that many were drawn
};

} // namespace attractor
