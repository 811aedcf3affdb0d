// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "document/variations/chance.h"

namespace document {

// Extent of the variation of maps.
struct MapVariation {
    double strength = 0;  // 0 … 1
    bool maySplit = true; // true: maps may be added and removed
    bool tames = false;   // true: all maps must contract; false: maps that expand may keep expanding
};

// The maps turned, stretched and moved, those aside that are locked or off; what belonged to a map that is
// gone goes too. The fractal holds a system.
void varyMaps(Fractal& fractal, const MapVariation& variation, Chance& chance);

// Varies weights at random around those of `before`, from which `fractal` comes; each map keeps its relation
// to the determinant rule. Their sum stays. Locked maps, and maps that are off, keep theirs.
void varyWeights(Fractal& fractal, const Fractal& before, double strength, Chance& chance);

} // namespace document
