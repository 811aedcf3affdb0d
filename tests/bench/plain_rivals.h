// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "attractor/samples/prepared_system.h"

#include <cstdint>
#include <span>
#include <vector>

// What a careful programmer writes without the engine: the references of the benchmark.
namespace rivals {

struct Points {
    std::vector<float> xy; // pairs, in the order of the chaos game
};
Points storedPoints(const attractor::PreparedSystem& system, std::size_t count);

// One orbit in doubles: mt19937, linear search in the cumulative probabilities. Fills `xy`, pairs.
void scalarOrbit(const attractor::PreparedSystem& system, std::span<double> xy);

// Every stored point through a 2×3 matrix, floor, bounds check, count.
void redrawStored(const Points& points, const attractor::Camera& camera, std::vector<std::uint32_t>& counts);

// The strongest plain chaos game: 16384-entry table of maps, xorshift, four interleaved orbits in floats.
void chaosIntoGrid(const attractor::PreparedSystem& system, const attractor::Camera& camera,
                   std::size_t points, std::vector<std::uint32_t>& counts);

} // namespace rivals
