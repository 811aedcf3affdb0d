// SPDX-License-Identifier: MIT
#include "space/space_outlines_item.h"

#include "canvas/items/analysis_item.h"
#include "space/seen_line.h"

#include <QPainter>

#include <algorithm>

namespace view {

void SpaceOutlinesItem::setShapes(std::vector<document::SpaceOutline> shapes) {
    m_shapes = std::move(shapes);
    layOut(m_camera);
}

void SpaceOutlinesItem::layOut(const attractor::OrbitCamera& camera) {
    prepareGeometryChange();
    m_camera = camera;
    m_seen.clear();
    m_bounds = {0, 0, double(camera.size.width), double(camera.size.height)};
    for (const document::SpaceOutline& shape : m_shapes) {
        Seen& seen = m_seen.emplace_back();
        const auto point = [&](int corner) { return shape.points[std::size_t(corner)]; };
        for (const auto& [a, b] : shape.edges)
            if (const auto edge = seenLine(camera, point(a), point(b))) seen.edges.push_back(*edge);
        if (!shape.edges.empty()) continue;
        for (const ifs::Vector<3>& alone : shape.points)
            if (inFront(camera, alone) > 0) seen.points.push_back(seenPoint(camera, alone));
    }
    update();
}

void SpaceOutlinesItem::setStyle(const OverlayStyle& style) {
    OverlayItem::setStyle(style);
    // Keeps thin coloured lines visible on any picture.
    m_style.halo.setAlpha(std::max(230, m_style.halo.alpha()));
}

void SpaceOutlinesItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    constexpr std::size_t fewToOutline = 100;
    const bool many = m_shapes.size() > fewToOutline;
    painter->setRenderHint(QPainter::Antialiasing);
    for (std::size_t k = 0; k < m_shapes.size(); ++k) {
        const document::SpaceOutline& shape = m_shapes[k];
        const QColor colour = shape.colour
                                  ? QColor(shape.colour->red, shape.colour->green, shape.colour->blue)
                                  : outlineColour(shape.kind, m_style.onDark);
        QPainterPath path;
        for (const QLineF& edge : m_seen[k].edges) {
            path.moveTo(edge.p1());
            path.lineTo(edge.p2());
        }
        const double width = m_style.lineWidth * (shape.isSelected ? 2 : 0.75);
        if (many)
            painter->strokePath(path, QPen(colour, shape.isSelected ? width : 1));
        else if (!path.isEmpty())
            strokeWithHalo(*painter, path, m_style, colour, width);
        painter->setPen(QPen(m_style.rim, 1.5));
        painter->setBrush(colour);
        for (const QPointF& point : m_seen[k].points)
            painter->drawEllipse(point, 4.5, 4.5);
    }
}

} // namespace view
