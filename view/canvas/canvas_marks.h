// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/overlay_style.h"
#include "canvas/snapping.h"

#include <QGraphicsItem>
#include <QPolygonF>

#include <optional>

namespace view {

// Where a dragged point has been caught: a ring on a vertex, short guides along the lines of the grid and the
// axes.
class SnapMark : public QGraphicsItem {
public:
    void setSnap(const std::optional<Snapped>& snap, const QPointF& pixel);
    void setStyle(const OverlayStyle& style);

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    std::optional<Snapped> m_snap;
    OverlayStyle m_style;
};

// The triangle being defined: the points clicked, and rubber lines to the pointer.
class RubberItem : public QGraphicsItem {
public:
    void setPoints(const QPolygonF& clicked, const std::optional<QPointF>& pointer); // pixels of the view
    void setStyle(const OverlayStyle& style);

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    QPolygonF m_clicked;
    std::optional<QPointF> m_pointer;
    OverlayStyle m_style;
};

} // namespace view
