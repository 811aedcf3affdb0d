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

// Whether any sample of the set can fall into the window with this word.
bool meets(const Word& word, const SampleSet& samples, const CellWindow& window);

// Adds `count` samples of the run of the word to `counts`, which has window.cells() + trashCells counters.
void splat(const Word& word, const SampleSet& samples, std::uint64_t count, const CellWindow& window,
           std::uint32_t* counts);

// A colour in linear light, 12 bits a channel, as it is summed per cell: {samples, red, green, blue}.
struct alignas(16) ColourCell {
    std::uint32_t samples = 0;
    std::uint32_t red = 0;
    std::uint32_t green = 0;
    std::uint32_t blue = 0;
};
// The same with a colour per sample; returns true when some sum is past 2³¹ and wants to be carried over.
bool splat(const Word& word, const SampleSet& samples, std::uint64_t count, const CellWindow& window,
           const ColourCell& colour, ColourCell* cells);

} // namespace attractor
