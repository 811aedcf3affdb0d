// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/orbit_camera.h"
#include "canvas/items/overlay_item.h"
#include "document/analysis/analysis.h"

#include <QLineF>

#include <vector>

namespace view {

// The shapes that the analysis draws over a solid.
class SpaceOutlinesItem : public OverlayItem {
public:
    void setShapes(std::vector<document::SpaceOutline> shapes);
    void layOut(const attractor::OrbitCamera& camera); // size in device-independent pixels
    void setStyle(const OverlayStyle& style) override;

    QRectF boundingRect() const override { return m_bounds; }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    struct Seen {
        std::vector<QLineF> edges;
        std::vector<QPointF> points; // points of a shape without edges
    };
    std::vector<document::SpaceOutline> m_shapes;
    std::vector<Seen> m_seen; // one for each shape
    attractor::OrbitCamera m_camera;
    QRectF m_bounds;
};

} // namespace view
