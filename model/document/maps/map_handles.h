// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "document/fractal/fractal_geometry.h"
#include "ifs/system/branch.h"

#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace document {

// The maps of a fractal as the images of its cage, to be dragged. Everything is in displayed coordinates and
// counted from the fractal as given, so that nothing accumulates and the way back is exact. The results hold
// the cage in force, so that it stays while the code changes under it.
class MapHandles {
public:
    // The fractal must be a system of the plane and `cage` its effective one. The maps are shown and moved as
    // they are seen inside the piece that `within` makes of the attractor.
    MapHandles(std::shared_ptr<const Fractal> fractal, const ifs::ControlCage<2>& cage,
               const ifs::AffineMap<2>& within = {});
    // The map of one branch as the only one, at index 0; moving it moves the displayed branch (Shape::moved)
    // and leaves the code alone. With `recurs` the same branch moves inside it too, and so on. The word has
    // indices of maps that take part.
    static MapHandles ofBranch(const std::shared_ptr<const Fractal>& fractal, const ifs::ControlCage<2>& cage,
                               const ifs::Word& branch, bool recurs = false);

    std::size_t count() const { return maps().size(); }
    const std::vector<ifs::WeightedMap<2>>& maps() const {
        return m_branch.empty() ? std::get<Shape<2>>(m_fractal->shape).system.maps : m_branchMap;
    }
    std::vector<ifs::Vector<2>> corners(std::size_t index) const; // images of the cage's vertices
    // Polygon of the corners, bent with the cage.
    std::vector<ifs::Vector<2>> outline(std::size_t index) const;

    // Boxes around the images of the cage, soon found for many maps. Where the cage bends they are where
    // their middles are shown, but as large as its affine fit makes them.
    std::vector<Box> boxes() const;
    bool bends() const { return m_placement.bend() != nullptr; }

    // Maps can be moved unless the placement, or the piece, is flat.
    bool canBeMoved() const;

    // Moves one corner of a map: a change of rank one.
    Fractal withCornerMoved(std::size_t index, std::size_t corner, const ifs::Vector<2>& offset) const;
    // Moves maps. Where the cage bends, this and the following are of first order in the middle of each map.
    Fractal withMapsMoved(std::span<const std::size_t> indices, const ifs::Vector<2>& offset) const;
    Fractal withMapsMoved(std::span<const std::size_t> indices,
                          std::span<const ifs::Vector<2>> offsets) const; // one offset for each map
    Fractal withMapsChanged(std::span<const std::size_t> indices, const ifs::AffineMap<2>& change) const;
    // Turns each map about its image of `root`, a point in coordinates of the code: branches that swing.
    Fractal withMapsSwung(std::span<const std::size_t> indices, const ifs::Vector<2>& root,
                          double angle) const;

private:
    ifs::AffineMap<2> around(std::size_t index) const; // first-order display of a map
    // `change` in coordinates of the piece, after the map.
    void change(Fractal& fractal, std::size_t index, const ifs::AffineMap<2>& change) const;
    void changeDisplayed(Fractal& fractal, std::size_t index, const ifs::AffineMap<2>& change) const;
    Fractal changed() const; // copy of the fractal with the cage

    std::shared_ptr<const Fractal> m_fractal;
    ifs::ControlCage<2> m_cage;
    ifs::Placement m_placement;
    ifs::AffineMap<2> m_within;
    std::vector<ifs::MapId> m_branch;
    std::vector<ifs::WeightedMap<2>> m_branchMap;
};

// Meaning of a change of a branch for the code.
enum class BranchEdit {
    Display, // moves only this branch as displayed; the code stays
    OwnMap,  // replaces the system by the cut set of the address, with the branch as the first map
    LastMap, // changes the last map of the address as seen there, and with it all branches that it makes
    Inside,  // Display, repeated inside the branch: recurring_branches.h
};
inline bool keepsCode(BranchEdit edit) {
    return edit == BranchEdit::Display || edit == BranchEdit::Inside;
}

// The same with the branch, a word of indices, where its maps put it; as it is when there is no such branch.
Fractal withBranchPutBack(Fractal fractal, const ifs::Word& branch);
bool isMoved(const Fractal& fractal, const ifs::Word& branch);

// change∘w_σ of a branch of the system that changes inside itself, which it does only where this contracts;
// w_σ of others.
ifs::AffineMap<2> recurringMap(const Fractal& fractal, const ifs::Word& branch);

// The lowest displayed point, in coordinates of the code: where a plant stands.
std::optional<ifs::Vector<2>> root(const Fractal& fractal);

} // namespace document
