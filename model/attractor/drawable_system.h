// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/renderer.h"
#include "ifs/affine_map.h"
#include "ifs/branch.h"
#include "ifs/iterated_function_system.h"

#include <cstddef>
#include <span>
#include <vector>

namespace attractor {

// The maps that take part, and where their attractor lies.
struct DrawableSystem {
    std::vector<ifs::AffineMap<2>> maps;
    std::vector<double> probabilities;      // positive, sum 1
    std::vector<std::size_t> index;         // place of each map in the system
    std::vector<ifs::MovedBranch<2>> moved; // words over `maps`
    // The attractor lies in the box centre ± halfExtent; half extents are positive. A system without an
    // attractor gets a box in which its orbits spend most of their time.
    ifs::Vector<2> centre = ifs::Vector<2>::Zero();
    ifs::Vector<2> halfExtent = ifs::Vector<2>::Ones();
    // Σ p ln‖A‖. Unless it is negative, composing maps only expands, and restarted orbits are all there is.
    double meanLogarithm = 0;
    RenderNote note = RenderNote::None; // None, NoMaps, NoAttractor or Undecided
};

// `moved` has words over places in the system; a word with a map that takes no part names nothing.
DrawableSystem drawable(const ifs::IteratedFunctionSystem<2>& system,
                        std::span<const ifs::MovedBranch<2>> moved = {});

// change∘w_word for every piece of what is shown.
std::vector<ifs::AffineMap<2>> shownPieces(const DrawableSystem& system);

} // namespace attractor
