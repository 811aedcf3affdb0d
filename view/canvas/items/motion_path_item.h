// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/items/overlay_item.h"

#include <QPolygonF>

#include <vector>

namespace view {

// The ways of what is keyed: a dot for each frame, and a diamond for each key.
class MotionPathItem : public OverlayItem {
public:
    struct Way {
        QPolygonF points; // pixels of the view, as the keys
        QPolygonF keys;
        friend bool operator==(const Way&, const Way&) = default;
    };
    void setWays(std::vector<Way> ways);

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    std::vector<Way> m_ways;
};

} // namespace view
