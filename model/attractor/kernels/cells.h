// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace attractor {

// Rows [firstRow, endRow) of a grid of the given width, kept in memory; cells count from row firstRow.
struct CellWindow {
    int width = 0;
    int firstRow = 0;
    int endRow = 0;

    std::size_t cells() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(endRow - firstRow);
    }
};

// Samples outside the window fall into these extra counters behind the cells instead of being branched
// around.
constexpr std::size_t overflowCells = 16;

// A rectangle of cells of the window, ends excluded; empty where an end is not past its beginning.
struct CellRegion {
    int firstColumn = 0;
    int endColumn = 0;
    int firstRow = 0; // first row of the grid, as in CellWindow
    int endRow = 0;

    friend bool operator==(const CellRegion&, const CellRegion&) = default;
};
// A colour in linear light, 12 bits per channel, as it is summed per cell: {samples, red, green, blue}.
struct alignas(16) ColourCell {
    std::uint32_t samples = 0;
    std::uint32_t red = 0;
    std::uint32_t green = 0;
    std::uint32_t blue = 0;
};

} // namespace attractor
