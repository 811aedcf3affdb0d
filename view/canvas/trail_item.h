// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/overlay_style.h"

#include <QGraphicsItem>
#include <QPolygonF>

namespace view {

// The last jumps of a chaos game: fading lines to where its point is now.
class TrailItem : public QGraphicsItem {
public:
    void setPoints(const QPolygonF& points); // pixels of the view, the newest last
    void setStyle(const OverlayStyle& style);

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    QPolygonF m_points;
    OverlayStyle m_style;
};

} // namespace view
