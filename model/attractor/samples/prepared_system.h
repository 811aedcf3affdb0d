// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/render_request.h"
#include "ifs/existence/attractor_existence.h"
#include "ifs/system/affine_map.h"
#include "ifs/system/branch.h"
#include "ifs/system/iterated_function_system.h"
#include "ifs/system/links.h"

#include <cstdint>
#include <span>
#include <vector>

namespace attractor {

// The maps that take part, and where their attractor lies.
struct PreparedSystem : ifs::ActiveMaps<2> {
    std::vector<ifs::MovedBranch<2>> moved{}; // changes with words over `maps`
    // The attractor lies in the box centre ± halfExtent; half extents are positive. A system without an
    // attractor gets a box in which its orbits spend most of their time.
    ifs::Vector<2> centre = ifs::Vector<2>::Zero();
    ifs::Vector<2> halfExtent = ifs::Vector<2>::Ones();
    // Σ p ln‖A‖. Unless it is negative, composing maps only expands, and restarted orbits are all there is.
    double meanLogarithm = 0;
    RenderNote note = RenderNote::None; // None, NoMaps, NoAttractor or Undecided
    bool coincides = false;             // true if some short words of unlinked maps are the same map

    // The Markov chain of linked maps, and for each map the sample set of the points to which it is applied.
    // Empty without links.
    ifs::Transitions chain{};
    std::vector<std::uint32_t> sampleSetOf{};
};

// `moved` has words over indices in the system; a word with a map that takes no part names nothing.
PreparedSystem prepared(const ifs::IteratedFunctionSystem<2>& system,
                        std::span<const ifs::MovedBranch<2>> moved = {});

// The maps change∘w_word of all displayed pieces.
std::vector<ifs::AffineMap<2>> shownPieces(const PreparedSystem& system);

// Why a system of that verdict may not be drawn as expected.
RenderNote existenceNote(ifs::Verdict verdict);

} // namespace attractor
