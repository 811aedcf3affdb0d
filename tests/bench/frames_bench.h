// SPDX-License-Identifier: MIT
#pragma once

#include "bench/time_bench.h"
#include "document/fractal/fractal.h"

#include <vector>

// What the frames of an animation cost beside the drawing, and pictures that several machines share.
namespace frames_bench {

document::Fractal windyMaple(int length); // frames

// Of animations of so many frames, 1920 × 1080.
std::vector<timing::Row> measure(int frames, int repetitions);

} // namespace frames_bench
