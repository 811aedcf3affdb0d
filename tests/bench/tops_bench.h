// SPDX-License-Identifier: MIT
#pragma once

#include "bench/space_bench.h"

// Stealing colours against the density: 10⁷ samples of the fern, 1920 × 1080, one thread.
namespace tops_bench {

// The shortest of `repetitions` times each; what is compared takes turns.
std::vector<space::Ratio> measure(int repetitions);

} // namespace tops_bench
