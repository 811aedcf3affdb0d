// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/kernels/cells.h"

#include <array>
#include <cstddef>
#include <cstdint>

// Counting samples in space: what kernels.h has for the plane, with a third coordinate.
namespace attractor::kernels {

// camera·cage·w_σ as an affine map from box coordinates to cells.
struct CloudWord {
    std::array<float, 3> column{};
    std::array<float, 3> row{};
    float x = 0;
    float y = 0;
};

struct SpaceRun {
    const float* x = nullptr;
    const float* y = nullptr;
    const float* z = nullptr;
    std::size_t count = 0; // arrays are read up to a multiple of kernels::chunk
};

// Counts every point of the run in its cell of the window, or in an overflow cell.
void addToCounts(const CloudWord& word, const SpaceRun& run, const CellWindow& window, std::uint32_t* counts);
// A faster version for runs known to lie in the window.
void addInside(const CloudWord& word, const SpaceRun& run, const CellWindow& window, std::uint32_t* counts);
// Returns the bits seen in all sums.
std::uint32_t addToColours(const CloudWord& word, const SpaceRun& run, const CellWindow& window,
                           const ColourCell& colour, ColourCell* cells);

} // namespace attractor::kernels
