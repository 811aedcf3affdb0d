// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/camera.h"
#include "canvas/canvas_tool.h"
#include "canvas/pan_gesture.h"
#include "canvas/pinch_gesture.h"
#include "canvas/snapping.h"
#include "document/document.h"
#include "document/map_handles.h"
#include "ifs/barycentric.h"

#include <QGraphicsView>
#include <QImage>
#include <QPointer>
#include <QTimer>

#include <functional>
#include <memory>
#include <optional>

class QTouchEvent;

namespace document {
struct OutlineShape;
}

namespace view {

class BranchTool;
class CageTool;
class CanvasScene;
class DefineTool;
class MapsTool;
class PolygonTool;
class RenderBridge;

struct PointerPosition {
    ifs::Vector<2> world = ifs::Vector<2>::Zero();
    // With respect to the first three vertices of the current cage; nullopt while they lie on one line.
    std::optional<ifs::Barycentric<2>> barycentric;
    // Of the point of the attractor under the pointer, by places in the system; empty where there is none and
    // while something is dragged. The fixed point, displayed, is that of its first `fixedLength` maps.
    ifs::Word address{};
    std::size_t fixedLength = 0;
    std::optional<ifs::Vector<2>> fixedPoint{};
};

// The window onto the plane. The scene is in device-independent pixels of the viewport and the view's own
// transform stays the identity; a camera leads from the plane to the pixels, so zooming knows no limit but
// that of the numbers.
class CanvasView : public QGraphicsView {
    Q_OBJECT

public:
    enum class Tool { Cage, Maps, Branch, DefineTriangle };

    CanvasView(document::Document* document, RenderBridge* bridge, QWidget* parent = nullptr);
    ~CanvasView() override;

    // DefineTriangle asks first when the placement is flat, and may stay off.
    void setTool(Tool tool);
    Tool tool() const { return m_tool; }
    bool cancelGesture(); // false when none was under way

    // The maps that are selected, in the order of the system.
    const std::vector<ifs::MapId>& selectedMaps() const;
    void selectMaps(const std::vector<ifs::MapId>& maps);
    // Whether dragging a map may lead where there is no attractor; else the drag stops there.
    void setAllowsNoAttractor(bool allows);
    // How much of a change of maps, after(0) to after(1), may be shown; when not all, the canvas says why.
    double shareToShow(const std::function<document::Fractal(double)>& after);
    void dismissStop(); // takes that sentence away

    // The branch that is selected with the tool Branch: the beginning, `branchDepth` maps long, of the
    // address of the point that was clicked. Words are of places in the system.
    const ifs::Word& branchAddress() const;
    int branchDepth() const;
    void setBranchDepth(int depth);
    void setBranchEdit(document::BranchEdit edit);

    void fit();                 // picture and cage into the view
    void zoomBy(double factor); // about the middle
    void resetZoom();           // 100 %: one unit of the plane is a hundred pixels; the middle stays
    double zoom() const { return camera().pixelsPerUnit / 100; }
    const attractor::Camera& camera() const;
    void setYAxis(attractor::YAxis yAxis);
    attractor::YAxis yAxis() const { return camera().yAxis; }

    void setGridVisible(bool visible);
    void setAxesVisible(bool visible);
    void setOverlaysVisible(bool visible); // all but the picture
    bool isGridVisible() const;
    bool areAxesVisible() const;
    bool overlaysVisible() const;
    void setSnapping(Snapping snapping);
    Snapping snapping() const;
    void showOutlines(std::vector<document::OutlineShape> shapes); // of an analysis
    void showTrail(const std::vector<ifs::Vector<2>>& points);     // of a chaos game, the newest last
    QString hint() const { return m_hint; }
    void setHint(const QString& hint); // for a first run: shown until the first gesture or another tool

    QString note() const; // the sentence about the picture, if one is shown
    QImage picture()
        const; // the picture as it is seen, in device pixels, without what lies over it; null before one
    void copyPicture() const;

    const CanvasScene& canvas() const { return *m_scene; }

    void focusOn(const CanvasPart& part); // as Tab does

    void insertVertexAt(int edge, const QPointF& position); // pixels

signals:
    void toolChanged(view::CanvasView::Tool tool);
    void selectedMapsChanged();
    void branchChanged(); // address or depth
    void pointerMoved(const view::PointerPosition& position);
    void pointerLeft();
    void message(const QString& sentence); // for the status bar
    void viewChanged();                    // camera
    void overlaysVisibleChanged(bool visible);
    void gridVisibleChanged(bool visible);
    void axesVisibleChanged(bool visible);
    void yAxisChanged(attractor::YAxis yAxis);
    void snappingChanged(view::Snapping snapping);
    void hintDismissed();

protected:
    bool event(QEvent* event) override;
    bool viewportEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    bool focusNextPrevChild(bool next) override;

private:
    enum class Holding { Nothing, Tool, Plane }; // by a button that is down

    CanvasTool& active() const;
    PolygonTool* taking() const; // the tool in use when it takes polygons, else null
    void setCamera(attractor::Camera camera);
    void adoptViewport(); // its size and pixel ratio
    void followDocument(const document::Change& change);
    void holdPainting();
    void paintAgain();
    void finishTool();
    void dismissHint();
    bool offerReset(); // whether the placement is flat, so that a question is open now
    bool canvasKey(const QKeyEvent& event);
    void pan(const QPointF& pixels);
    void report(const QPointF& position);
    void findAddress(PointerPosition& pointer);
    void refreshCursor();
    void updateModifiers(Qt::KeyboardModifiers modifiers);
    void describeFocus();
    void zoomAt(const QPointF& position, double factor);
    bool touch(const QTouchEvent& event);

    QPointer<document::Document> m_document;
    RenderBridge* m_bridge;
    CanvasScene* m_scene;
    CageTool* m_cageTool;
    MapsTool* m_mapsTool;
    BranchTool* m_branchTool;
    DefineTool* m_defineTool;
    Tool m_tool = Tool::Cage;
    Holding m_holding = Holding::Nothing;
    PanGesture m_pan;
    PinchGesture m_pinch;
    Pointer m_pointer;
    QTimer m_hold; // runs while painting waits for a frame
    bool m_spaceHeld = false;
    int m_wheelTurned = 0; // of a notch that is not complete
    bool m_fitted = true;  // follows the size of the window until the user moves the view
    bool m_placed = false; // has been shown once
    QString m_hint;
};

} // namespace view

Q_DECLARE_METATYPE(view::PointerPosition)
