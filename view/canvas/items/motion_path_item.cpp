// SPDX-License-Identifier: MIT
#include "canvas/items/motion_path_item.h"

#include <QPainter>
#include <QPainterPath>

namespace view {

namespace {

constexpr double pathDot = 1.6;
constexpr double key = 4.5;
constexpr double pathApart = 4; // pixels between dots that are drawn

} // namespace

void MotionPathItem::setWays(std::vector<Way> ways, std::vector<QPolygonF> ghosts) {
    if (ways == m_ways && ghosts == m_ghosts) return;
    prepareGeometryChange();
    m_ways = std::move(ways);
    m_ghosts = std::move(ghosts);
    update();
}

QRectF MotionPathItem::boundingRect() const {
    QRectF all;
    for (const Way& way : m_ways)
        all |= way.points.boundingRect().adjusted(-8, -8, 8, 8);
    for (const QPolygonF& ghost : m_ghosts)
        all |= ghost.boundingRect().adjusted(-8, -8, 8, 8);
    return all;
}

void MotionPathItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    painter->setRenderHint(QPainter::Antialiasing);
    for (const QPolygonF& ghost : m_ghosts) {
        QPainterPath outline;
        outline.addPolygon(ghost);
        outline.closeSubpath();
        painter->setOpacity(0.35);
        strokeSeen(*painter, outline, m_style, m_style.accent, 1);
    }
    for (const Way& way : m_ways) {
        QPainterPath line;
        line.addPolygon(way.points);
        painter->setOpacity(0.6);
        strokeSeen(*painter, line, m_style, m_style.line, 1);
        painter->setPen(Qt::NoPen);
        painter->setBrush(m_style.rim);
        QPointF last = way.points.value(0);
        for (const QPointF& point : way.points) {
            if ((point - last).manhattanLength() < pathApart) continue;
            last = point;
            painter->drawEllipse(point, pathDot, pathDot);
        }
        painter->setOpacity(1);
        painter->setPen(QPen(m_style.rim, 1.5));
        painter->setBrush(m_style.accent);
        for (const QPointF& at : way.keys)
            painter->drawPolygon(QPolygonF(
                {at + QPointF(0, -key), at + QPointF(key, 0), at + QPointF(0, key), at + QPointF(-key, 0)}));
    }
}

} // namespace view
