// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/renderer.h"
#include "canvas/canvas_part.h"
#include "canvas/gizmo_item.h"
#include "canvas/overlay_style.h"
#include "canvas/snapping.h"
#include "document/addresses.h"
#include "document/document.h"
#include "document/map_handles.h"
#include "ifs/control_cage.h"

#include <QGraphicsScene>

#include <memory>
#include <optional>
#include <vector>

namespace document {
struct OutlineShape;
}

namespace view {

class AnalysisItem;
class AttractorItem;
class BandItem;
class CageItem;
class GridItem;
struct MapFrame;
class MapFramesItem;
class NoteItem;
class RubberItem;
class SnapMark;
class TrailItem;

// What is on the canvas, in device-independent pixels of the view, y down; the camera leads to the plane.
// Follows the document and never edits it.
class CanvasScene : public QGraphicsScene {
    Q_OBJECT

public:
    explicit CanvasScene(document::Document* document, QObject* parent = nullptr);
    ~CanvasScene() override;

    document::Document& document() const { return *m_document; }
    const attractor::Camera& camera() const { return m_camera; }
    void setView(const attractor::Camera& camera, double devicePixelRatio);
    void setFrame(std::shared_ptr<const attractor::Frame> frame);
    void setDesktop(const QPalette& palette, const QFont& font);

    // The cage in force; nullopt when the entry is not a system of the plane.
    const std::optional<ifs::ControlCage<2>>& cage() const { return m_cage; }
    QPolygonF cagePolygon() const;

    // What the handles take hold of: the cage, or the maps as its images. Of those that are not taken the
    // selected ones are hinted at.
    enum class Taken { Cage, Maps, Branch };
    Taken taken() const { return m_taken; }
    void setTaken(Taken taken);
    int mapCount() const { return m_handles ? int(m_handles->count()) : 0; }
    const std::vector<ifs::MapId>& selectedMaps() const { return m_selectedMaps; } // in the system's order
    void setSelectedMaps(const std::vector<ifs::MapId>& maps);
    std::vector<std::size_t> selectedPlaces() const;
    void setSelectedPlaces(const std::vector<std::size_t>& places);
    bool isSelected(int place) const;
    // The maps that are taken have frames, or of very many those near the view, if need be thinned out.
    bool areMapsThinnedOut() const { return m_taken == Taken::Maps && m_thinned; }
    int frameCount() const;
    const MapFrame* frameOf(int place) const; // nullptr: none
    // The maps whose frames, the images of the cage, lie in `band`, in pixels.
    std::vector<std::size_t> placesWithin(const QRectF& band) const;

    // Vertices of the cage that move together, in increasing order; those that are left when some have gone:
    // none.
    const std::vector<std::size_t>& selectedVertices() const { return m_selectedVertices; }
    void setSelectedVertices(std::vector<std::size_t> vertices);

    // The branch that is taken, by places in the system; empty: none.
    const ifs::Word& branch() const { return m_branch; }
    void setBranch(const ifs::Word& branch);
    // Addresses of what is displayed; made when first asked for.
    const document::Addresses& addresses();
    ifs::Word addressAt(const QPointF& position);

    // About which what is taken turns and scales: the mean of its vertices until it is put elsewhere.
    ifs::Vector<2> pivot() const;
    void setPivot(const std::optional<ifs::Vector<2>>& pivot); // nullopt: the mean again
    bool hasOwnPivot() const { return m_pivot.has_value(); }

    // What a press would take hold of: from the geometry, whatever has been painted.
    CanvasPart partAt(const QPointF& position, Reach reach) const;
    bool exists(const CanvasPart& part) const; // none does always
    QPointF positionOf(const CanvasPart& part) const;
    std::vector<CanvasPart> handles() const; // those the keyboard walks through, in that order
    QString nameOf(const CanvasPart& part) const;
    QString placeOf(const CanvasPart& part) const; // coordinates, or what the arrow keys do
    QString useOf(const CanvasPart& part) const;   // of a handle without a number: what dragging it does

    CanvasPart hovered() const { return m_hovered; }
    CanvasPart pressed() const { return m_pressed; }
    CanvasPart focused() const { return m_focused; }
    void setHovered(CanvasPart part);
    void setPressed(CanvasPart part);
    void setFocused(CanvasPart part);
    void holdKnobAt(
        const std::optional<QPointF>& position); // the pressed rotate or scale handle follows the pointer

    Snapping snapping() const { return m_snapping; }
    void setSnapping(Snapping snapping) { m_snapping = snapping; }
    // Without those vertices of the part that move.
    SnapTargets snapTargets(const CanvasPart& part = {}, const std::vector<int>& moving = {}) const;
    void showSnap(const std::optional<Snapped>& snap);
    void showBand(const QRectF& band); // that selects, in pixels; empty: none
    void showRubber(const std::vector<ifs::Vector<2>>& clicked, const std::optional<ifs::Vector<2>>& pointer);

    void showOutlines(std::vector<document::OutlineShape> shapes); // of an analysis
    void showTrail(const std::vector<ifs::Vector<2>>& points);     // of a chaos game, the newest last

    void setPrompt(const QString& prompt); // what the tool asks for; empty: none
    void setHint(const QString& hint);     // shown while there is no prompt
    QString note() const;                  // the sentence shown about the picture

    void setGridVisible(bool visible);
    void setAxesVisible(bool visible);
    bool isGridVisible() const;
    bool areAxesVisible() const;
    void setOverlaysVisible(bool visible);
    bool overlaysVisible() const { return m_overlaysVisible; }
    void setCageVisible(bool visible); // off while another triangle is being defined

signals:
    void focusChanged();
    void focusMoved(); // the part in focus is elsewhere
    void selectedMapsChanged();

private:
    void follow(const document::Change& change);
    void place(); // everything that depends on camera and cage
    void placeMaps();
    QPolygonF inPixels(const std::vector<ifs::Vector<2>>& points) const;
    QRectF inPixels(const document::Box& box) const;
    std::vector<std::size_t> placesShown(const std::vector<bool>& isChosen); // of maps that are taken
    // The polygons that are taken when the cage is not: of the maps, or of the branch.
    int childCount() const;
    std::vector<ifs::Vector<2>> childCorners(int child) const;
    bool anythingTaken() const { return m_taken == Taken::Cage || !takenPoints().empty(); }
    void takeBranch();
    std::vector<ifs::Vector<2>> takenPoints() const;
    void mark();
    void restyle();
    void updateNote();
    void updateVisibility();
    void raiseTaken();
    std::vector<OverlayItem*> overlays() const;

    document::Document* m_document;
    attractor::Camera m_camera;
    std::shared_ptr<const attractor::Frame> m_frame;
    std::optional<ifs::ControlCage<2>> m_cage;
    std::optional<document::MapHandles> m_handles;
    Taken m_taken = Taken::Cage;
    std::vector<QColor> m_mapColours;
    bool m_thinned = false;
    std::vector<ifs::MapId> m_selectedMaps;
    std::vector<std::size_t> m_selectedVertices;
    ifs::Word m_branch;
    std::optional<document::MapHandles> m_branchHandles; // as it is shown, at place 0
    std::optional<document::Addresses> m_addresses;
    std::optional<ifs::Vector<2>> m_pivot;
    std::optional<QPointF> m_heldKnob;
    std::optional<Snapped> m_snap;
    std::vector<ifs::Vector<2>> m_clicked;
    std::vector<ifs::Vector<2>> m_trail;
    std::optional<ifs::Vector<2>> m_rubberEnd;
    GizmoLayout m_gizmoLayout;
    CanvasPart m_hovered;
    CanvasPart m_pressed;
    CanvasPart m_focused;
    Snapping m_snapping;
    QString m_prompt;
    QString m_hint;
    bool m_overlaysVisible = true;
    bool m_cageVisible = true;
    QPalette m_palette;
    attractor::RenderNote m_noted = attractor::RenderNote::None;
    bool m_noteStale = true;

    std::unique_ptr<AttractorItem> m_attractor;
    std::unique_ptr<GridItem> m_grid;
    std::unique_ptr<AnalysisItem> m_analysisItem;
    std::unique_ptr<CageItem> m_cageItem;
    std::unique_ptr<MapFramesItem> m_mapFrames;
    std::unique_ptr<GizmoItem> m_gizmo;
    std::unique_ptr<SnapMark> m_snapMark;
    std::unique_ptr<TrailItem> m_trailItem;
    std::unique_ptr<RubberItem> m_rubber;
    std::unique_ptr<BandItem> m_band;
    std::unique_ptr<NoteItem> m_noteItem;
    std::unique_ptr<NoteItem> m_promptItem;
};

} // namespace view
