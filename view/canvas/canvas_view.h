// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/canvas_input.h"
#include "gestures/corners_in_view.h"
#include "gestures/viewport.h"

#include <QImage>
#include <QTimer>

#include <memory>

namespace view {

class RenderBridge;

// The window onto the plane.
class CanvasView : public Viewport {
    Q_OBJECT

public:
    using Tool = Toolbox::Tool;

    CanvasView(document::Document* document, RenderBridge* bridge, QWidget* parent = nullptr);
    ~CanvasView() override;

    // DefineTriangle asks first when the placement is flat, and may stay off.
    void setTool(Tool tool) { m_tools.setTool(tool); }
    Tool tool() const { return m_tools.tool(); }
    Toolbox& tools() { return m_tools; }

    // The maps that are selected, in the order of the system.
    const std::vector<ifs::MapId>& selectedMaps() const { return m_scene->selection().maps(); }
    void selectMaps(const std::vector<ifs::MapId>& maps) { m_scene->selection().setMaps(maps); }

    void setMapFaces(document::MapFaces faces) { m_scene->handles().setFaces(std::move(faces)); }
    // Map pointed at in the table; None: none.
    void pointAt(ifs::MapId map) { m_scene->selection().setPointed(map); }

    CanvasNavigation& navigation() { return m_navigation; }
    const attractor::Camera& camera() const { return m_scene->camera(); }
    void fit() { m_navigation.fit(); }
    CanvasOptions& options() { return m_options; }
    const CanvasOptions& options() const { return m_options; }
    const CanvasScene& canvas() const { return *m_scene; }

    // Outlines of an analysis; `outer` contain the cylinders among the shapes, of which a click chooses one.
    void showOutlines(std::vector<document::OutlineShape> shapes,
                      std::vector<document::OutlineShape> outer = {});
    void showTrail(const std::vector<ifs::Vector<2>>& points); // points of a chaos game, newest last
    const QString& hint() const { return m_scene->notes().hint(); }
    void setHint(const QString& hint); // help for a first run, shown until the first gesture or another tool
    void dismissHint();
    void setCovered(const QRect& area); // part of the viewport under a card, which notes avoid
    QString note() const { return m_scene->notes().note(); } // remark on the picture, if any
    // The visible picture, in device pixels, without overlays; null before one.
    QImage picture() const;

signals:
    void toolChanged(view::CanvasView::Tool tool);
    void selectedMapsChanged();
    void pointerMoved(const view::PointerPosition& position);
    void hintDismissed();

protected:
    ViewportInput& input() override { return m_input; }
    ViewNavigation& navigated() override { return m_navigation; }
    void adoptDesktop() override;
    void begin() override { fit(); }
    void contextMenuEvent(QContextMenuEvent* event) override;
    bool focusNextPrevChild(bool next) override;

private:
    void setUpWidget();
    void connectParts();
    void followDocument(const document::Change& change);
    bool areCornersInView() const;
    void holdPainting();
    void paintAgain();
    void offerReset();
    void showMenu(const CanvasPart& part, const QPoint& global);
    void describeFocus();

    document::Document* m_document;
    RenderBridge* m_bridge;
    CanvasScene* m_scene;
    CanvasOptions m_options;
    CanvasNavigation m_navigation;
    Toolbox m_tools;
    CanvasInput m_input;
    CornersInView m_corners;
    QTimer m_hold;  // running while painting waits for a frame
    QString m_said; // text about the part with the focus, while the status bar shows it
};

} // namespace view
