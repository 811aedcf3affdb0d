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
    Dimensions, // one in the plane and one in space, or one unreadable
    Measure,    // no covariance of the measure of one of them
    TooMany,    // more than 256 maps
    Linked,     // linked maps in one of them
    BentCage,   // no code for the picture of one of them
};

// An entry without a cage that shows the first fractal at frame 0 and the second at frame `length`, both as
// their cages place them, and in between how the maps of the one become those of the other. Moved branches
// stay behind. Pins are indices of maps; of maps that stand for several, all copies are pinned.
struct MorphOutcome {
    std::optional<Fractal> fractal;
    MorphFlaw flaw = MorphFlaw::Dimensions; // valid if there is no fractal
    // Indices of all maps, and the share of the weight that they carry.
    std::vector<animation::Shipment> pairs{};
    bool isOfSecond = false; // true if the flaw is in the second fractal
};
MorphOutcome morphed(const Fractal& from, const Fractal& to, int length,
                     std::span<const animation::Pin> pins);

} // namespace document
