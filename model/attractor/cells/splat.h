// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/kernels/cells.h"
#include "attractor/kernels/sample_set.h"
#include "attractor/kernels/word.h"

#include <cstdint>

namespace attractor {

// The cells into which samples of the set can fall under this word.
CellRegion reachedCells(const ShownWord& shown, const SampleSet& samples, const CellWindow& window);
// Returns true if a sample of the set can fall into the window under this word.
bool meets(const ShownWord& shown, const SampleSet& samples, const CellWindow& window);

// Adds `count` samples of the run of the word to `counts`, which has window.cells() + overflowCells counters.
void splat(const ShownWord& shown, const SampleSet& samples, std::uint64_t count, const CellWindow& window,
           std::uint32_t* counts);

// The same with a colour per sample; returns true when some sum is past 2³¹ and wants to be carried over.
bool splat(const ShownWord& shown, const SampleSet& samples, std::uint64_t count, const CellWindow& window,
           const ColourCell& colour, ColourCell* cells);

} // namespace attractor
