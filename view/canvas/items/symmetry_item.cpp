// SPDX-License-Identifier: MIT
#include "canvas/items/symmetry_item.h"

#include <QPainter>
#include <QPainterPath>

namespace view {

namespace {

constexpr double knobRadius = 6;

QPainterPath pathOf(const QPointF& from, const QPointF& to) {
    QPainterPath path(from);
    path.lineTo(to);
    return path;
}

} // namespace

void SymmetryItem::setMarks(const std::optional<SymmetryMarks>& marks) {
    if (marks == m_marks) return;
    prepareGeometryChange();
    m_marks = marks;
    update();
}

std::optional<QPointF> SymmetryItem::knob() const {
    return m_marks && isVisible() ? std::optional(m_marks->knob) : std::nullopt;
}

void SymmetryItem::setHeld(bool held) {
    m_held = held;
    update();
}

QRectF SymmetryItem::boundingRect() const {
    if (!m_marks) return {};
    QRectF all(m_marks->centre, QSizeF(1, 1));
    all |= QRectF(m_marks->knob, QSizeF(1, 1)) | m_marks->spokes.boundingRect();
    for (const QLineF& mirror : m_marks->mirrors)
        all |= QRectF(mirror.p1(), mirror.p2()).normalized();
    return all.adjusted(-12, -12, 12, 12);
}

void SymmetryItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    if (!m_marks) return;
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setOpacity(0.8);
    for (const QLineF& mirror : m_marks->mirrors)
        strokeSeen(*painter, pathOf(mirror.p1(), mirror.p2()), m_style, m_style.line, 1, Qt::DashLine);
    for (const QPointF& end : m_marks->spokes)
        strokeSeen(*painter, pathOf(m_marks->centre, end), m_style, m_style.line, 1);
    painter->setOpacity(1);
    strokeSeen(*painter, pathOf(m_marks->centre, m_marks->knob), m_style, m_style.line, 1);
    painter->setPen(QPen(m_style.rim, 2));
    painter->setBrush(m_held ? m_style.accent : m_style.core);
    painter->drawPolygon(
        QPolygonF({m_marks->knob + QPointF(0, -knobRadius), m_marks->knob + QPointF(knobRadius, 0),
                   m_marks->knob + QPointF(0, knobRadius), m_marks->knob + QPointF(-knobRadius, 0)}));
}

} // namespace view
