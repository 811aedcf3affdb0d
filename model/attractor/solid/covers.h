// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/kernels/solid_walk.h"
#include "attractor/samples/prepared_space.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace attractor {

// Points of an attractor at relative scales 1, 1/2, 1/4, 1/8, …: to a solid what samples are to a density.
// One point for every cell of a cut of the address tree; where cells crowd, one for each that are alike.
class Covers {
public:
    static constexpr std::size_t maxPoints = 1U << 14; // points of one cover

    Covers() = default;
    explicit Covers(const PreparedSpace& system); // requires at least one map

    // Covers of at most `points` points, from the coarsest to the finest; the coarsest is always included.
    // Views.
    std::vector<kernels::Cover> ofAtMost(std::size_t points) const;
    // True if views of either are valid for both.
    bool isSame(const Covers& other) const { return m_covers == other.m_covers; }

private:
    struct Points {
        float spacing = 1;
        std::size_t count = 0;
        std::size_t padded = 0;
        std::vector<float> coordinates; // x, y and z of each octant
    };
    std::shared_ptr<const std::vector<Points>> m_covers;
};

} // namespace attractor
