// SPDX-License-Identifier: MIT
#pragma once

#include "animation/morph.h"
#include "document/fractal/fractal.h"

#include <optional>
#include <span>
#include <vector>

namespace document {

// Why there is no morph.
enum class MorphFlaw {
    Dimensions, // one is in the plane and the other in space, or one could not be read
    Measure,    // the measure of one of them has no covariance
    TooMany,    // more than 256 maps
    Linked,     // the maps of one of them are linked
    BentCage,   // the picture of one of them has no code
};

// An entry without a cage that shows the first fractal at frame 0 and the second at frame `length`, both as
// their cages place them, and in between how the maps of the one become those of the other. Moved branches
// stay behind. Pins are indices of maps; of maps that stand for several, all copies are pinned.
struct MorphOutcome {
    std::optional<Fractal> fractal;
    MorphFlaw flaw = MorphFlaw::Dimensions;   // where there is none
    std::vector<animation::Shipment> pairs{}; // indices of all maps, and what share of the weight they carry
    bool isOfSecond = false;                  // the flaw, where it is not that of the first
};
MorphOutcome morphed(const Fractal& from, const Fractal& to, int length,
                     std::span<const animation::Pin> pins);

} // namespace document
