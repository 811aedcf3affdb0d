// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/kernels/sample_set.h"
#include "attractor/samples/prepared_space.h"

#include <cstdint>
#include <vector>

namespace attractor {

// Points of the invariant measure in coordinates in which the box of the system is [−1, 1]³.
// SampleSet::size points; each array repeats its beginning once more, so that any run is contiguous.
struct SpaceSamples {
    std::vector<float> x;
    std::vector<float> y;
    std::vector<float> z;
    float reach = 1; // bound of all coordinates; above 1 if the box does not hold all samples
};

// 64 orbits that have forgotten their start, with streams of their own for every (seed, pass). The same bits
// on every machine. An orbit that escapes begins anew in the middle of the box.
void drawSamples(const PreparedSpace& system, std::uint64_t seed, std::uint64_t pass, SpaceSamples& samples);

} // namespace attractor
