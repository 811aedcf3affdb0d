// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "document/variations/filling.h"
#include "document/variations/may_change.h"

#include <QString>

#include <cstdint>
#include <memory>
#include <stop_token>

namespace document {

// Why there is nothing to vary, as a sentence; empty where there is.
QString variationObstacle(const Fractal& fractal);

// Settings for varying a fractal.
struct Mutation {
    double strength = 0.3; // 0 … 1, from hardly changed to hardly recognisable
    MayChange may{};
    // Fractal to cross with first, of the same dimension; null: none.
    std::shared_ptr<const Fractal> partner{};
};

// Variations of a fractal: its maps turned, stretched and moved a little, now and then with a map more or
// less, in other hues and with other weights. Name, comments, labels, placement and locked maps stay; a cage
// at rest goes, so that it fits the new system. docs/mathematics.md, "Random systems and variations".
class Variations {
public:
    // `parent` has no variationObstacle(). Takes as long as pairing its maps with those of the partner.
    Variations(std::shared_ptr<const Fractal> parent, Mutation mutation);
    ~Variations();

    // The same seed gives the same fractal, and the same maps whether colours may change or not. If the shape
    // may change, it has an attractor, for certain, which fills its view about as well as the parent's, or
    // well; where maps are locked so that nothing near the parent is certain, it is the parent. Stopped, it
    // may be any fractal.
    Fractal of(std::uint64_t seed, const std::stop_token& stop = {}) const;

private:
    class Crossings;
    struct Varied {
        Fractal fractal;
        Fractal from;      // fractal whose maps were varied
        double fills = -1; // fillsAs(); < 0 without a certain attractor
    };

    Varied shaped(std::uint64_t seed, const std::stop_token& stop) const;
    Fractal start(std::uint64_t seed, int trial) const;

    std::shared_ptr<const Fractal> m_parent;
    Mutation m_mutation;
    Filling m_wanted;
    std::unique_ptr<const Crossings> m_crossings; // null without a partner
};

// A single variation.
Fractal variation(const Fractal& fractal, const Mutation& mutation, std::uint64_t seed);

} // namespace document
