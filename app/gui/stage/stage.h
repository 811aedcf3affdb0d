// SPDX-License-Identifier: MIT
#pragma once

#include "bridges/extent_finder.h"
#include "canvas/canvas_view.h"
#include "compare/compare_pane.h"
#include "document/saved_views.h"
#include "space/four_views.h"
#include "transformation/transformation_view.h"

#include <QSplitter>
#include <QStackedWidget>

// The middle of the window: the canvas of the plane, or the window into space for an entry in space; and
// perhaps another entry beside it.
class Stage : public QSplitter {
    Q_OBJECT

public:
    Stage(document::Document* document, view::RenderBridge* render, view::SolidBridge* solid,
          QWidget* parent = nullptr);

    view::CanvasView* plane() { return m_plane; }
    view::TransformationView* transformation() { return m_transformation; } // parent of the canvas
    view::FourViews* views() { return m_space; }
    view::ComparePane* compare() { return m_compare; }   // pane to the right of the canvas
    view::SpaceView* space() { return m_space->main(); } // view that orbits
    bool showsSpace() const { return m_views->currentWidget() == m_space; }

    void setCompared(bool compared); // shows or hides the other entry, to the right of the canvas

    // Operations on the canvas that is shown:
    void fit();
    void keepFitted() { navigation().adoptViewport(); } // no effect once the user has moved the view
    void zoomBy(double factor);
    void resetZoom() { navigation().resetZoom(); }
    QImage picture() const;
    document::SavedView::Camera camera() const;
    void lookAt(const document::SavedView::Camera& camera); // ignores cameras of the other dimension
    bool cancelGesture();
    void takeFocus(Qt::FocusReason reason = Qt::OtherFocusReason);

signals:
    void switched(); // sent when plane and space change places

private:
    void follow(const document::Document& document);
    view::ViewNavigation& navigation();

    view::ExtentFinder m_extentFinder;
    QStackedWidget* m_views;
    view::CanvasView* m_plane;
    view::TransformationView* m_transformation;
    view::FourViews* m_space;
    view::ComparePane* m_compare;
};
