// SPDX-License-Identifier: MIT
#pragma once

#include "gestures/corners_in_view.h"
#include "gestures/viewport.h"
#include "space/solid_item.h"
#include "space/space_input.h"
#include "space/space_outlines_item.h"

#include <optional>

namespace view {

class NoteItem;

// The window into space: the solid, its tetrahedron held by four handles, and the ball of axes. Orbits where
// the canvas of the plane would do nothing.
class SpaceView : public Viewport {
    Q_OBJECT

public:
    SpaceView(document::Document* document, SolidBridge* bridge, QWidget* parent = nullptr);
    ~SpaceView() override;

    SpaceNavigation& navigation() { return m_navigation; }
    const SpaceNavigation& navigation() const { return m_navigation; }
    void setOverlaysVisible(bool visible);
    // The object held by the pointer: the cage, the maps, a branch, or nothing while clicks define another
    // tetrahedron.
    enum class Target { Cage, Maps, Branch, Definition };
    void setTarget(Target target);
    void setBranchChoice(BranchChoice* choice); // source of the chosen branch; null: none can be chosen
    void setStereo(attractor::Stereo stereo); // stereo mode; side by side, nothing on the canvas can be held
    // Nullopt unless maps can be held.
    std::optional<std::size_t> heldMap() const { return m_maps.selected(); }
    // Or none; `among`: others that are selected.
    void holdMap(std::optional<std::size_t> index, std::vector<ifs::MapId> among = {});
    std::vector<std::size_t> selectedMaps() const { return m_maps.selection(); } // includes the held map
    std::vector<ifs::MapId> selectedIds() const { return m_maps.selectedIds(); }
    void setAllowsNoAttractor(bool allows) { m_input.setAllowsNoAttractor(allows); }
    // Fixes the direction of view, under that title; a drag where nothing is held pans.
    void fixDirection(const attractor::Direction& direction, const QString& title);
    const SpaceCageItem& mapItem() const { return *m_mapItem; } // held map or branch
    QImage picture() const { return m_solid->picture(); }       // device pixels; null before the first frame
    void showOutlines(std::vector<document::SpaceOutline> shapes);
    const SpaceCageItem& cageItem() const { return *m_cageItem; }
    const SliceItem& sliceItem() const { return *m_slice; }
    const SymmetryItem& symmetryItem() const { return *m_symmetry; }
    const AxisBall& ball() const { return *m_ball; }
    QString note() const; // remark on the picture, if any

signals:
    void pointerMoved(const view::SpacePosition& position);
    void defined();                  // sent when a tetrahedron is defined or the definition is cancelled
    void mapHeld(std::size_t index); // sent for holds by the user, possibly with other maps selected
    void mapsSelected();             // sent for selections made elsewhere

protected:
    ViewportInput& input() override { return m_input; }
    ViewNavigation& navigated() override { return m_navigation; }
    void adoptDesktop() override;
    void begin() override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    bool focusNextPrevChild(bool next) override;

private:
    void setUpWidget();
    void followInput();
    void followDocument(const document::Change& change);
    void followFractal(const document::Change& change);
    void followCamera(const document::Change& change);
    void lookAsKeyed(bool isMoving); // no effect without keys of the camera
    bool areCornersInView() const;
    void layOut();
    void layOutSlice();
    bool areOverlaysShown() const;
    bool holdsMap() const { return m_maps.isActive() || m_branch.isActive(); } // also true for a branch
    void showNote();
    void setCage(const std::optional<ifs::ControlCage<3>>& cage);
    void refreshMarks();
    void describeFocus();
    QString focusText() const;
    QString ballText(const AxisBall::End& end) const;
    bool isFixed() const { return m_navigation.isFixed(); }
    void showMenu(const QPoint& global);

    document::Document* m_document;
    SolidBridge* m_bridge;
    SolidItem* m_solid;
    SpaceOutlinesItem* m_outlines;
    SpaceCageItem* m_cageItem;
    SpaceOutlinesItem* m_mapOutlines;
    SpaceCageItem* m_mapItem;
    SpaceOutlinesItem* m_definitionLines;
    SliceItem* m_slice;
    SymmetryItem* m_symmetry;
    AxisBall* m_ball;
    BorderArrowsItem* m_arrows;
    NoteItem* m_note;
    NoteItem* m_title;
    SpaceNavigation m_navigation;
    SpaceMaps m_maps;
    SpaceBranch m_branch;
    SpaceDefinition m_definition;
    SpaceInput m_input;
    CornersInView m_corners;
    std::optional<ifs::ControlCage<3>> m_cage;  // present cage; nullopt if the entry is not in space
    SpaceCageItem::Faces m_faces;               // faces of the cage
    std::vector<ifs::Vector<3>> m_around;       // corners of the box around the sliced set
    QString m_stop;                             // reason why a drag stops
    std::vector<animation::CameraTurn> m_orbit; // orbit of the document's camera
    bool m_overlays = true;
    bool m_isExtentKnown = false;
};

} // namespace view
