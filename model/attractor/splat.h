// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/address_cut.h"
#include "attractor/chaos_game.h"

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
constexpr std::size_t trashCells = 16;

// A rectangle of cells of the window, ends excluded; empty where an end is not past its beginning.
struct CellRegion {
    int firstColumn = 0;
    int endColumn = 0;
    int firstRow = 0; // of the grid, as in CellWindow
    int endRow = 0;

    friend bool operator==(const CellRegion&, const CellRegion&) = default;
};
// Where the samples of the set can fall with this word, and with the curve that it may have.
CellRegion reachedCells(const Word& word, const SampleSet& samples, const CellWindow& window,
                        const Curve* curve = nullptr);
// Whether any sample of the set can fall into the window with this word.
bool meets(const Word& word, const SampleSet& samples, const CellWindow& window,
           const Curve* curve = nullptr);

// Adds `count` samples of the run of the word to `counts`, which has window.cells() + trashCells counters.
void splat(const Word& word, const SampleSet& samples, std::uint64_t count, const CellWindow& window,
           std::uint32_t* counts, const Curve* curve = nullptr);

// A colour in linear light, 12 bits a channel, as it is summed per cell: {samples, red, green, blue}.
struct alignas(16) ColourCell {
    std::uint32_t samples = 0;
    std::uint32_t red = 0;
    std::uint32_t green = 0;
    std::uint32_t blue = 0;
};
// The same with a colour per sample; returns true when some sum is past 2³¹ and wants to be carried over.
bool splat(const Word& word, const SampleSet& samples, std::uint64_t count, const CellWindow& window,
           const ColourCell& colour, ColourCell* cells, const Curve* curve = nullptr);

} // namespace attractor
