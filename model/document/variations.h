// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal.h"

#include <cstdint>

// New systems by chance. The same seed gives the same system. Every system given has an attractor that fills
// its view: neither dust nor a line, and nothing of it so thin that it would not be seen.
namespace document {

// Share of the cells of a coarse grid over the box of what is displayed that hold points; 0 without a
// certified box.
double shareOfView(const Fractal& fractal);

// Between two and five contractions.
Fractal randomFractal(std::uint64_t seed);

// `fractal` with its maps turned, stretched and moved a little, now and then with a map more or less;
// `strength` from 0 (nearly the same) to 1 (hardly to be recognised). Name, comments, placement and
// appearance stay. The system must be plane; returns `fractal` when nothing near it fills its view.
Fractal variation(const Fractal& fractal, double strength, std::uint64_t seed);

} // namespace document
