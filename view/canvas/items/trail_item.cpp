// SPDX-License-Identifier: MIT
#include "canvas/items/trail_item.h"

#include <QPainter>
#include <QPainterPath>

namespace view {

namespace {

constexpr double newest = 6; // pixels; radius of the newest point, below the disc of a jump

} // namespace

void TrailItem::setPoints(const QPolygonF& points) {
    if (points == m_points) return;
    prepareGeometryChange();
    m_points = points;
    update();
}

QRectF TrailItem::boundingRect() const {
    return m_points.boundingRect().adjusted(-9, -9, 9, 9);
}

void TrailItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    if (m_points.isEmpty()) return;
    painter->setRenderHint(QPainter::Antialiasing);
    const qsizetype count = m_points.size();
    for (qsizetype i = 1; i < count; ++i) {
        QPainterPath jump(m_points[i - 1]);
        jump.lineTo(m_points[i]);
        painter->setOpacity(double(i) / double(count - 1));
        strokeLit(*painter, jump, m_style, m_style.lineWidth);
    }
    painter->setOpacity(1);
    painter->setPen(QPen(m_style.rim, m_style.lineWidth));
    painter->setBrush(m_style.accent);
    painter->drawEllipse(m_points.back(), newest, newest);
}

} // namespace view
