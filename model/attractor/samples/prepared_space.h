// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/render_request.h"
#include "ifs/system/affine_map.h"
#include "ifs/system/branch.h"
#include "ifs/system/iterated_function_system.h"

#include <array>
#include <span>
#include <vector>

namespace attractor {

// The maps of a system in space that take part, and where their attractor lies.
struct PreparedSpace : ifs::ActiveMaps<3> {
    // The attractor lies in the box centre ± halfExtent; half extents are positive. A system without an
    // attractor gets a box in which its orbits spend most of their time.
    ifs::Vector<3> centre = ifs::Vector<3>::Zero();
    ifs::Vector<3> halfExtent = ifs::Vector<3>::Ones();
    bool isCertified = false; // true if the box is certified
    // Composing maps shrinks: an attractor is known, or orbits contract in the mean.
    bool contracts = true;
    RenderNote note = RenderNote::None;       // None, NoMaps, NoAttractor or Undecided
    std::vector<ifs::MovedBranch<3>> moved{}; // changes with words over `maps`

    // The map in coordinates in which the box is [−1, 1]³.
    ifs::AffineMap<3> inBox(const ifs::AffineMap<3>& map) const;
    ifs::AffineMap<3> fromBox() const; // box coordinates → coordinates of the code

    // A displayed piece: all points whose address begins with `word`, under `map` = change∘w_word in box
    // coordinates. Walks of the address tree begin with the pieces; without moved branches, with its root.
    struct Piece {
        ifs::Word word;
        ifs::AffineMap<3> map;
        bool isMoved = false; // false: `map` is the product of the maps
    };
    std::vector<Piece> pieces() const;
};

// `moved` has words over indices in the system; a word with a map that takes no part names nothing.
PreparedSpace preparedSpace(const ifs::IteratedFunctionSystem<3>& system,
                            std::span<const ifs::MovedBranch<3>> moved = {});

// Maps in box coordinates, one array per coefficient (linear by rows, then the shift), padded with zeros to a
// multiple of 16.
struct BoxMaps {
    explicit BoxMaps(const PreparedSpace& system);
    std::array<std::vector<float>, 12> coefficients;
};

} // namespace attractor
