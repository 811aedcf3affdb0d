// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/render/renderer.h"
#include "canvas/geometry/snapping.h"
#include "canvas/items/gizmo_item.h"
#include "canvas/items/grid_item.h"
#include "canvas/scene/canvas_notes.h"
#include "canvas/scene/canvas_selection.h"
#include "canvas/scene/handle_model.h"
#include "canvas/scene/hit_tester.h"
#include "canvas/scene/transient_marks.h"
#include "document/moments/motion_paths.h"
#include "gestures/pointer.h"

#include <QGraphicsScene>

#include <memory>
#include <optional>
#include <vector>

namespace view {

class AttractorItem;
class CageItem;
class MotionPathItem;
class ShadowItem;
class SymmetryItem;

// Content of the canvas, in device-independent pixels of the view, y down; the camera leads to the plane.
// Places the items. Follows the document and never edits it.
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

    CanvasSelection& selection() { return m_selection; }
    const CanvasSelection& selection() const { return m_selection; }
    HandleModel& handles() { return m_handles; }
    const HandleModel& handles() const { return m_handles; }
    TransientMarks& marks() { return m_marks; }
    const TransientMarks& marks() const { return m_marks; }
    CanvasNotes& notes() { return m_notes; }
    GridItem& grid() const { return *m_grid; }
    // Items that have their own handles, whichever tool is in use.
    struct Knobs {
        SymmetryItem& symmetry;
        ShadowItem& shadow;
    };
    Knobs knobs() const { return {*m_symmetryItem, *m_shadowItem}; }

    QPolygonF cagePolygon() const;
    const std::vector<MapFrame>& frames() const { return m_mapFrames->frames(); } // sorted by index
    // True if there are too many maps to show each frame.
    bool areMapsThinnedOut() const { return m_isThinnedOut; }
    HitTester hitTester() const { return {m_handles, m_camera, m_gizmoLayout, frames()}; }
    CanvasPart partAt(const QPointF& position, Reach reach) const; // none if the handles are hidden
    QPointF positionOf(const CanvasPart& part) const { return hitTester().positionOf(part); }
    // The key whose diamond on a path is at the position and not covered by a handle, and the part it moves.
    struct KeyOnPath {
        int frame = 0;
        CanvasPart part; // vertex of the cage, or the inside of a map
    };
    std::optional<KeyOnPath> keyAt(const QPointF& position, Reach reach) const;

    // The pressed rotate or scale handle follows the pointer.
    void holdKnobAt(const std::optional<QPointF>& position);

    Snapping snapping() const { return m_snapping; }
    void setSnapping(Snapping snapping) { m_snapping = snapping; }
    // Snap targets without those vertices of the part that move.
    SnapTargets snapTargets(const CanvasPart& part = {}, const std::vector<int>& moving = {}) const;

    void setOverlaysVisible(bool visible);
    bool overlaysVisible() const { return m_overlaysVisible; }
    void setCageVisible(bool visible); // false while a triangle is being defined

    // Defers the layout of the items: while a batch exists they stay, and at its end they are laid out once
    // if necessary.
    class Batch {
    public:
        explicit Batch(CanvasScene& scene) : m_scene(scene) { ++m_scene.m_batches; }
        ~Batch();
        Batch(const Batch&) = delete;
        Batch& operator=(const Batch&) = delete;

    private:
        CanvasScene& m_scene;
    };

private:
    void follow(const document::Change& change);
    void changeTarget();
    void dropWhatIsGone();
    void requestLayout();
    void layoutItems(); // places all items that depend on camera, cage and maps
    void layoutFrames();
    void layoutPaths();
    void layoutKnobs();                                     // places the knobs of symmetry and shadow
    const std::vector<document::MotionPath>& paths() const; // paths of the selected object
    std::vector<QPolygonF> ghosts() const;
    std::vector<QPointF> handlePositions() const;
    void mark();
    void restyle();
    void updateNote();
    void updateVisibility();
    void raiseHeld();
    std::vector<OverlayItem*> overlays();

    document::Document* m_document;
    CanvasSelection m_selection;
    HandleModel m_handles;
    TransientMarks m_marks;
    CanvasNotes m_notes;
    attractor::Camera m_camera;
    std::shared_ptr<const attractor::Frame> m_frame;
    GizmoLayout m_gizmoLayout;
    std::optional<QPointF> m_heldKnob;
    Snapping m_snapping;
    QPalette m_palette;
    bool m_isThinnedOut = false;
    bool m_overlaysVisible = true;
    bool m_cageVisible = true;
    bool m_isLayoutStale = false;
    int m_batches = 0;

    std::unique_ptr<AttractorItem> m_attractor;
    document::MotionPaths m_paths; // paths of the animation
    std::unique_ptr<GridItem> m_grid;
    std::unique_ptr<MotionPathItem> m_pathItem;
    std::unique_ptr<SymmetryItem> m_symmetryItem;
    std::unique_ptr<ShadowItem> m_shadowItem;
    std::unique_ptr<CageItem> m_cageItem;
    std::unique_ptr<MapFramesItem> m_mapFrames;
    std::unique_ptr<GizmoItem> m_gizmo;
};

} // namespace view
