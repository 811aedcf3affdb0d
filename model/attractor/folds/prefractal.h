// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/cells/cell_sums.h"
#include "attractor/cut/address_cut.h"

#include <functional>
#include <stop_token>
#include <vector>

namespace attractor {

// Wⁿ(polygon), the deterministic algorithm: all N^n images of the polygon, filled, one sample in each cell
// that an image covers (at least the cell of its middle), and more along the sides of those that are not
// small. Images outside the window are not followed, and an image that has shrunk into a cell is not divided
// any more.
struct Prefractal {
    const PreparedSystem& system;
    std::vector<ifs::Vector<2>> polygon; // coordinates of the code; at least one point
    int iterations = 0;
    ColourCoordinates colours{}; // empty: colours along the address

    using Colour = std::function<ColourCell(std::uint32_t firstMap, double addressCoordinate)>;
    // Returns false when stopped. `colour` serves for sums of colours; sums of counts leave it alone.
    bool draw(const Projection& projection, const Colour& colour, CellSums& sums,
              const std::stop_token& stop) const;
};

// The most iterations, up to `wanted`, with no more than a million images.
int affordableIterations(std::size_t maps, int wanted);

} // namespace attractor
