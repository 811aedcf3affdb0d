// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/items/overlay_item.h"

#include <QPolygonF>

namespace view {

// Positions of the handles that turn and scale the whole cage, in pixels of the view.
struct GizmoLayout {
    QPointF pivot;
    QPointF rotate;
    QPointF scale;
    bool isPivotCovered = false; // true if a vertex lies there, which is hit first
};

// Places the handles beside the right corners of the cage, kept inside the view and apart from each other and
// from the vertices.
GizmoLayout gizmoLayout(const QPolygonF& cage, const QPointF& pivot, const QRectF& view);

// The pivot and the two handles beside the cage. Without modifier keys they do what Ctrl and Alt do with a
// drag. While something else is being dragged only the pivot, or what is pressed, is shown.
class GizmoItem : public HandlesItem {
public:
    void setView(const QRectF& view);
    void setLayout(const GizmoLayout& layout);

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    void paintPivot(QPainter& painter) const;
    void paintKnob(QPainter& painter, CanvasPart::Kind kind, const QPointF& at) const;

    QRectF m_view;
    GizmoLayout m_layout;
};

} // namespace view
