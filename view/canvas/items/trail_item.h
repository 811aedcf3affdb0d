// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/items/overlay_item.h"

#include <QPolygonF>

namespace view {

// The last jumps of a chaos game: fading lines to where its point is now.
class TrailItem : public OverlayItem {
public:
    void setPoints(const QPolygonF& points); // pixels of the view, newest last

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    QPolygonF m_points;
};

} // namespace view
