// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

namespace document {

// Measure of how well an attractor fills a view that is fitted to it. Dust and lines fill it badly.
struct Filling {
    double share = 0;  // share of occupied cells of a coarse grid over its box
    double aspect = 0; // ratio of its shortest to its longest extent
};
constexpr Filling wellFilled{0.12, 0.25};

// The filling of the code, without what its cage does to it; in space as it is seen at first. Zero without a
// certified attractor.
Filling filling(const Fractal& fractal);

// Ratio of two fillings: at least 1 where a view is filled as well as `wanted`.
double fillsAs(const Filling& filling, const Filling& wanted);

// Returns true if the maps that take part are proved to have an attractor.
bool hasCertainAttractor(const Fractal& fractal);

} // namespace document
