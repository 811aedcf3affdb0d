// SPDX-License-Identifier: MIT
#pragma once

#include "document/analysis/analysis.h"
#include "document/document.h"
#include "document/maps/space_map_handles.h"
#include "space/space_cage_item.h"
#include "space/space_outlines_item.h"
#include "space/spatial_drag.h"

#include <QCoreApplication>
#include <QPointF>
#include <QString>

#include <optional>
#include <vector>

namespace view {

// The edges of a tetrahedron that a map makes of the cage's.
document::SpaceOutline tetrahedron(const document::SpaceMapHandles::Corners& corners,
                                   const attractor::Rgba& colour);
// Handles of a map: its corners and its middle, which moves it as a whole.
std::vector<ifs::Vector<3>> handlesOf(const document::SpaceMapHandles::Corners& corners);
// Faces of a tetrahedron, counter-clockwise seen from outside.
SpaceCageItem::Faces facesOfTetrahedron();

class SpaceMapDrag;

// The maps of the current entry in space as the images of its tetrahedron. One of them may be held: by its
// four corners and, as the fifth handle, by its middle, which moves it as a whole.
class SpaceMaps {
    Q_DECLARE_TR_FUNCTIONS(SpaceMaps)

public:
    static constexpr std::size_t middle = 4;

    SpaceMaps(const document::Document* document, SpaceOutlinesItem& all, SpaceCageItem& held)
        : m_document(document), m_all(all), m_held(held) {}

    bool isActive() const { return m_isActive; }
    void setActive(bool active);

    std::size_t count() const;
    // The map that is held; nullopt while there is none.
    std::optional<std::size_t> selected() const;
    // Holds a map, among others that are selected, or none; false when that is so already.
    bool select(std::optional<std::size_t> index, std::vector<ifs::MapId> among = {});
    std::vector<std::size_t> selection() const; // includes the held map
    std::vector<ifs::MapId> selectedIds() const;
    // A click on a map that is not held. It holds one of several selected maps without giving up the others;
    // `adds` selects and holds one more, or gives one up.
    void pick(std::size_t index, bool adds);
    bool selectIds(const std::vector<ifs::MapId>& ids); // also holds one of them; false if nothing changes
    // The map that has a corner there and is not held; of several the nearest to the eye.
    std::optional<std::size_t> mapAt(const QPointF& position) const;

    void layOut(const attractor::OrbitCamera& camera, const std::optional<ifs::ControlCage<3>>& cage,
                const SpaceCageItem::Hidden& isHidden);

    // A drag of the held map, and of the others that are selected and not locked; nullopt where there can be
    // none, and why.
    std::optional<SpaceMapDrag> drag(QString& obstacle) const;
    // The name of that step for one corner of the held map, or for all of it.
    QString stepText(DragMode mode, std::optional<std::size_t> corner) const;

private:
    std::vector<std::size_t> moving() const; // maps that a drag moves, first the held one

    struct Dot {
        QPointF pixel;
        double depth = 0;
        std::size_t map = 0;
    };

    const document::Document* m_document;
    SpaceOutlinesItem& m_all;
    SpaceCageItem& m_held;
    std::vector<Dot> m_dots; // corners of the maps that are not held
    std::optional<std::size_t> m_selected = 0;
    std::vector<ifs::MapId> m_among;
    bool m_isActive = false;
};

// A drag of maps in space, the first of which is held, based on the maps when it began.
class SpaceMapDrag {
public:
    // nullopt while the maps cannot be moved, because the placement is flat. `inside`: the branch that is
    // moved and moves inside itself.
    static std::optional<SpaceMapDrag> of(document::SpaceMapHandles handles, std::vector<std::size_t> maps,
                                          ifs::Word inside = {});

    // The corners and the middle of each map.
    std::vector<ifs::Vector<3>> vertices() const;
    // The fractal with the corners of the maps there or, where no corner has moved, all of them as far from
    // where they were as the middle of the held one; or as much of the way as leaves an attractor, or lets a
    // branch inside itself be smaller; then `stop` says why.
    struct Moved {
        document::Fractal fractal;
        QString stop;
    };
    enum class Safety { StopAtAttractor, Free };
    Moved at(const std::vector<ifs::Vector<3>>& vertices, Safety safety) const;

private:
    Q_DECLARE_TR_FUNCTIONS(SpaceMapDrag)

    SpaceMapDrag(document::SpaceMapHandles handles, std::vector<std::size_t> maps, ifs::Word inside);
    std::vector<document::SpaceMapHandles::Corners>
    offsets(const std::vector<ifs::Vector<3>>& vertices) const;

    document::SpaceMapHandles m_handles;
    std::vector<std::size_t> m_maps;
    std::vector<document::SpaceMapHandles::Corners> m_corners;
    ifs::Word m_inside;
};

} // namespace view
