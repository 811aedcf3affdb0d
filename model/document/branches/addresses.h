// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "ifs/system/branch.h"

#include <memory>
#include <optional>
#include <vector>

namespace document {

// The ids of the maps that a word of indices names.
template <int Dim>
std::vector<ifs::MapId> idsOf(const ifs::IteratedFunctionSystem<Dim>& system, const ifs::Word& indices) {
    std::vector<ifs::MapId> word;
    for (const int index : indices)
        word.push_back(system.maps[std::size_t(index)].id);
    return word;
}

// Addresses of displayed points. Words name maps by their indices in the system, outermost first.
class Addresses {
public:
    explicit Addresses(const Fractal& fractal);

    // The address of the point of the attractor nearest to `displayed`, as far as it can be told apart at
    // `pixel`, the size of one in the plane; empty when none is within a few pixels.
    ifs::Word at(const ifs::Vector<2>& displayed, double pixel) const;

    // The displayed position of the point whose address repeats the word; nullopt for the empty word.
    std::optional<ifs::Vector<2>> fixedPoint(const ifs::Word& word) const;

private:
    ifs::ActiveMaps<2> m_active;
    std::shared_ptr<const ifs::SupportFunction<2>> m_attractor;
    ifs::Placement m_placement;
    std::vector<ifs::MovedBranch<2>> m_pieces; // displayed pieces; words over the active maps
    // Inverse changes of the pieces; nullopt if singular.
    std::vector<std::optional<ifs::AffineMap<2>>> m_unmoved;
};

// The same in space, of a point of the attractor as it is displayed. Empty also as long as the extent is not
// known.
ifs::Word addressInSpace(const Fractal& fractal, const ifs::Vector<3>& displayed, double pixel);

// "3 2 3 2 …": the numbers that the user counts maps by, at most `longest` of them.
QString addressText(const ifs::Word& word, std::size_t longest);

} // namespace document
