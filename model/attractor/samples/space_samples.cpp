// SPDX-License-Identifier: MIT
#include "attractor/samples/space_samples.h"

#include "attractor/arithmetic/arithmetic.h"
#include "attractor/kernels/kernels.h"
#include "attractor/samples/chaos_game.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace attractor {

namespace {

struct Point {
    float x = 0, y = 0, z = 0;
};

} // namespace

void drawSamples(const PreparedSpace& system, std::uint64_t seed, std::uint64_t pass, SpaceSamples& samples) {
    constexpr std::size_t burnIn = 128;
    for (auto* array : {&samples.x, &samples.y, &samples.z})
        array->resize(2 * SampleSet::size + kernels::chunk);
    const AliasTable table(system.probabilities);
    const BoxMaps maps(system);
    const auto& m = maps.coefficients;
    std::array<Point, SampleSet::lanes> orbits{};
    std::uint64_t random = mixed(mixed(seed) + pass);
    constexpr std::size_t steps = SampleSet::size / SampleSet::lanes;
    for (std::size_t step = 0; step < burnIn + steps; ++step)
        for (std::size_t lane = 0; lane < SampleSet::lanes; ++lane) {
            Point& p = orbits[lane];
            const std::size_t i = table.draw(static_cast<std::uint32_t>(mixed(random++) >> 32));
            const auto row = [&](std::size_t k) {
                return ((m[3 * k][i] * p.x + m[3 * k + 1][i] * p.y) + m[3 * k + 2][i] * p.z) + m[9 + k][i];
            };
            Point next{row(0), row(1), row(2)};
            const bool near = std::abs(next.x) < escapeRadius && std::abs(next.y) < escapeRadius &&
                              std::abs(next.z) < escapeRadius; // false for NaN
            p = near ? next : Point{};
            if (step < burnIn) continue;
            const std::size_t at = (step - burnIn) * SampleSet::lanes + lane;
            samples.x[at] = p.x;
            samples.y[at] = p.y;
            samples.z[at] = p.z;
        }
    samples.reach = 1;
    for (auto* array : {&samples.x, &samples.y, &samples.z}) {
        for (std::size_t k = 0; k < SampleSet::size; ++k)
            samples.reach = std::max(samples.reach, std::abs((*array)[k]));
        repeatBeginning(*array);
    }
}

} // namespace attractor
