// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/splat.h"

namespace attractor {

// Adds `count` samples of the run of a word that has a curve, as splat() does for other words.
void splatCurved(const Word& word, const Curve& curve, const SampleSet& samples, std::uint64_t count,
                 const CellWindow& window, std::uint32_t* counts);
bool splatCurved(const Word& word, const Curve& curve, const SampleSet& samples, std::uint64_t count,
                 const CellWindow& window, const ColourCell& colour, ColourCell* cells);

} // namespace attractor
