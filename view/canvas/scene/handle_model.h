// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/scene/canvas_selection.h"
#include "document/branches/addresses.h"
#include "document/maps/map_handles.h"
#include "document/tops/map_faces.h"
#include "ifs/cage/control_cage.h"

#include <QFutureWatcher>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace view {

// Number of maps from which on finding their extent may take longer than the window may be busy.
constexpr std::size_t manyMaps = 10'000;

enum class HandleTarget { Cage, Maps, Branch };

// Geometry of the handles: of the cage, of the maps as its images, or of one branch. Positions are in the
// plane. Data about maps and the branch is computed on demand.
class HandleModel : public QObject {
    Q_OBJECT

public:
    HandleModel(const document::Document& document, const CanvasSelection& selection);

    void follow(const document::Change& change);

    // The cage in force; nullopt when the entry is not a system in the plane.
    const std::optional<ifs::ControlCage<2>>& cage() const { return m_cage; }
    std::size_t vertexCount() const { return m_cage ? m_cage->current.size() : 0; }

    HandleTarget target() const { return m_target; }
    void setTarget(HandleTarget target);
    const document::MapHandles* maps() const;      // nullptr: no cage
    const document::MapHandles* branchMap() const; // displayed branch, at index 0; nullptr: none

    // Maps of a partner look like their counterparts. Empty: like themselves.
    void setFaces(document::MapFaces faces);
    const document::MapFaces& faces() const { return m_faces; }
    attractor::Rgba colourOf(std::size_t map) const; // `map`: index in the system

    // The branch that is held, by indices in the system; empty: none.
    const ifs::Word& branch() const { return m_branch; }
    void setBranch(const ifs::Word& branch);
    // Addresses of displayed points; those of very many maps are found in the background. The first function
    // waits for them, the second returns nullptr until addressesFound().
    const document::Addresses& addresses() const;
    const document::Addresses* knownAddresses() const;
    // The address at a point, known to within `precision`; empty without a cage.
    ifs::Word addressAt(const ifs::Vector<2>& point, double precision) const;

    // The polygons that are held when the cage is not: of the maps, or of the branch.
    int childCount() const;
    std::vector<ifs::Vector<2>> corners(int child) const;
    std::vector<ifs::Vector<2>> heldPoints() const;
    bool isAnythingHeld() const; // false if all selected maps are locked

    // The point about which the handles turn and scale: the mean of the vertices until it is put elsewhere.
    ifs::Vector<2> pivot() const;
    void setPivot(const std::optional<ifs::Vector<2>>& pivot); // nullopt: mean of the vertices
    bool hasOwnPivot() const { return m_pivot.has_value(); }

    bool exists(const CanvasPart& part) const; // always true for no part
    std::vector<CanvasPart> parts() const;     // order of the keyboard focus
    // Vertices that stay while `moving` of the part move.
    std::vector<ifs::Vector<2>> stillPoints(const CanvasPart& part, const std::vector<int>& moving) const;

signals:
    void targetChanged();
    void changed(); // sent for the branch, the pivot or the faces
    void addressesFound();

private:
    using AddressesPointer = std::shared_ptr<const document::Addresses>;
    void findAddresses() const;

    const document::Document& m_document;
    const CanvasSelection& m_selection;
    std::optional<ifs::ControlCage<2>> m_cage;
    HandleTarget m_target = HandleTarget::Cage;
    document::MapFaces m_faces;
    ifs::Word m_branch;
    std::optional<ifs::Vector<2>> m_pivot;
    mutable std::optional<document::MapHandles> m_maps;
    mutable std::optional<document::MapHandles> m_branchMap;
    mutable bool m_isBranchMapKnown = false;
    mutable AddressesPointer m_addresses;
    mutable QFutureWatcher<AddressesPointer> m_finding;
};

} // namespace view
