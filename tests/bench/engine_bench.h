// SPDX-License-Identifier: MIT
#pragma once

#include "bench/engine_cases.h"

namespace engine {

// Register benchmarks: what a frame of the case costs, by parts, beside its plain rivals; and what the
// machine allows.
void addBenchmarks(Case& c);
void addRoofline();

} // namespace engine
