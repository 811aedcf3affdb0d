// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/kernels/sample_set.h"
#include "attractor/samples/prepared_system.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace attractor {

// The invariant measure in parts of about equal measure: words τ, none the beginning of another, in the order
// of their addresses. docs/mathematics.md, "Strata".
class AddressStrata {
public:
    // Switches to the strata of this system. A system without a certified attractor is left in one piece.
    // Costs nothing if isOf() the system already.
    void follow(const PreparedSystem& system);
    // Also true for a system of equal maps, probabilities and box.
    bool isOf(const PreparedSystem& system) const;

    std::size_t size() const { return m_strata.size(); }

    // Takes each of the independent points of μ through a word: x ← w_τ(x). The words follow each other so
    // that every run of points has each part of the measure in its proportion, as nearly as its length
    // allows. One point alone is still distributed as μ. The same bits on every machine.
    void spread(std::uint64_t random, SampleSet& samples) const;

private:
    // w_τ in box coordinates.
    struct Stratum {
        float xx = 1, xy = 0, yx = 0, yy = 1, x = 0, y = 0;
        std::uint32_t last = 0xffffffff; // end of the stratum on a scale of 2³² equal parts of the measure
    };
    struct Node;

    Node child(const Node& node, std::size_t map) const;
    std::size_t leaves(const Node& node, double threshold, std::size_t most) const;
    void add(const Node& node, double threshold, double& before);
    void makeGuide();

    ifs::ActiveMaps<2> m_maps; // maps in box coordinates
    PreparedSystem m_system;
    std::vector<Stratum> m_strata;
    std::vector<std::uint32_t> m_guide; // stratum in which each equal share of the 2³² parts begins
};

} // namespace attractor
