// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace attractor {

// Points of the invariant measure in coordinates in which the box of the system is [−1, 1]².
// `size` points; each array repeats its beginning once more, so that any run of `size` points is contiguous.
struct SampleSet {
    static constexpr std::size_t lanes = 64; // parallel orbits; the number never changes
    static constexpr std::size_t size = 16384;
    std::vector<float> x;
    std::vector<float> y;
    float lowX = 0, highX = 0, lowY = 0, highY = 0; // extremes
};

} // namespace attractor
