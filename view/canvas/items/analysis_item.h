// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "canvas/items/overlay_item.h"
#include "document/analysis/analysis.h"

#include <QPainterPath>

#include <vector>

namespace view {

// Results of an analysis drawn over the picture: box, hull, simplex, fixed points, ellipse, cylinders.
class AnalysisItem : public OverlayItem {
public:
    void setShapes(std::vector<document::OutlineShape> shapes); // coordinates in the plane
    void setView(const attractor::Camera& camera);
    void setStyle(const OverlayStyle& style) override;

    QRectF boundingRect() const override { return m_bounds; }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    void layoutShapes();

    std::vector<document::OutlineShape> m_shapes;
    std::vector<QPolygonF> m_pixels; // shapes in pixels
    QRectF m_bounds;
    attractor::Camera m_camera;
};

// The colour of an outline, on the canvas and in legends; that of map shapes is the map's.
QColor outlineColour(document::Outline kind, bool onDark);

} // namespace view
