// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/kernels/sample_set.h"
#include "attractor/samples/prepared_system.h"

#include <cstdint>
#include <vector>

namespace attractor {

// Draws samples of linked maps, one set for each number in `sampleSetOf`, as many as `sets` has: points of
// the invariant measure as they are when one of its maps is drawn next. The same bits on every machine. An
// orbit that escapes begins anew in the middle of the box.
void drawLinkedSamples(const PreparedSystem& system, std::uint64_t seed, std::uint64_t pass,
                       std::vector<SampleSet>& sets);

} // namespace attractor
