// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/items/overlay_item.h"

#include <QPolygonF>

#include <vector>

namespace view {

// The paths of keyed vertices or maps: a dot for each frame, and a diamond for each key; and their shapes at
// the neighbouring keys.
class MotionPathItem : public OverlayItem {
public:
    struct Way {
        QPolygonF points; // pixels of the view, like the keys
        QPolygonF keys;
        friend bool operator==(const Way&, const Way&) = default;
    };
    void setWays(std::vector<Way> ways, std::vector<QPolygonF> ghosts);
    const std::vector<Way>& ways() const { return m_ways; }
    const std::vector<QPolygonF>& ghosts() const { return m_ghosts; }

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    std::vector<Way> m_ways;
    std::vector<QPolygonF> m_ghosts; // closed polygons
};

} // namespace view
