// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "document/maps/map_handles.h"
#include "ifs/cage/cage_surface.h"
#include "ifs/cage/control_cage.h"
#include "ifs/system/branch.h"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace document {

// The maps of a fractal in space as the images of its tetrahedron, to be dragged: what MapHandles is for the
// plane. Everything is in displayed coordinates and counted from the fractal as given, so that nothing
// accumulates and the way back is exact. docs/mathematics.md, "Map handles".
class SpaceMapHandles {
public:
    using Corners = std::array<ifs::Vector<3>, 4>;

    // The fractal must be a system in space, and `cage` the one in force; of one of more than four vertices,
    // four make the largest tetrahedron, bent as the cage says. The maps are shown and moved as they are seen
    // inside the piece that `within` makes of the attractor.
    SpaceMapHandles(std::shared_ptr<const Fractal> fractal, const ifs::ControlCage<3>& cage,
                    const ifs::AffineMap<3>& within = {});
    // The map of one branch as the only one, at index 0; moving it moves the displayed branch (Shape::moved)
    // and leaves the code alone. With `recurs` the same branch moves inside it too, and so on. The word has
    // indices of maps.
    static SpaceMapHandles ofBranch(const std::shared_ptr<const Fractal>& fractal,
                                    const ifs::ControlCage<3>& cage, const ifs::Word& branch, bool recurs);

    std::size_t count() const { return m_branch.empty() ? system3(*m_fractal)->maps.size() : 1; }
    Corners corners(std::size_t index) const; // images of the tetrahedron's vertices
    // The same under w_σ, a word of indices, where the branch is shown; nullopt where one is of no map.
    std::optional<Corners> corners(const ifs::Word& branch) const;

    // Returns true unless the placement, or the piece, is flat.
    bool canBeMoved() const;
    // The fractal with the corners of one map moved by these offsets: a change of rank one for each that is
    // not 0. It holds the cage in force, so that it stays while the code changes under it. With no offset,
    // the fractal as it is. Maps must be movable. Where the cage bends, a corner that it takes nowhere stays.
    Fractal withCornersMoved(std::size_t index, const Corners& offsets) const;
    Fractal withCornersMoved(std::span<const std::size_t> indices, std::span<const Corners> offsets) const;
    // Turns each of these maps by an angle about its image of `root`, a point in coordinates of the code,
    // which stays: branches that swing. Counter-clockwise for the one to whom `axis`, of length 1, points.
    // Otherwise as above; where the cage bends, to first order in the middle of each map.
    Fractal withMapsSwung(std::span<const std::size_t> indices, const ifs::Vector<3>& root,
                          const ifs::Vector<3>& axis, double angle) const;

private:
    ifs::AffineMap<3> mapAt(std::size_t index) const;
    // nullopt where the cage is flat.
    std::optional<ifs::AffineMap<3>> swung(const ifs::AffineMap<3>& map, const ifs::Vector<3>& root,
                                           const ifs::Matrix<3>& turn) const;
    ifs::Vector<3> shown(const ifs::Vector<3>& x) const;
    void moveCorners(Fractal& fractal, std::size_t index, const Corners& offsets) const;
    // The offset of x that moves its displayed point by `offset`.
    ifs::Vector<3> inPiece(const ifs::Vector<3>& x, const ifs::Vector<3>& offset) const;

    std::shared_ptr<const Fractal> m_fractal;
    ifs::ControlCage<3> m_cage;
    ifs::Simplex<3> m_rest;
    ifs::AffineMap<3> m_placed;              // display of a map if nothing bends
    std::optional<ifs::AffineMap<3>> m_back; // inverse of m_placed or, if the cage bends, of m_within
    ifs::AffineMap<3> m_within;
    std::shared_ptr<const ifs::CageDeformation> m_bend; // applied after m_within
    std::vector<ifs::MapId> m_branch;                   // moved branch; empty: maps are edited
    ifs::AffineMap<3> m_branchMap;
};

// The lowest displayed point in space, in coordinates of the code: where a plant stands. nullopt without an
// attractor, and where it or the cage is not known.
std::optional<ifs::Vector<3>> rootInSpace(const Fractal& fractal, const ifs::Vector<3>& up);

} // namespace document
