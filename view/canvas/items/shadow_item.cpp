// SPDX-License-Identifier: MIT
#include "canvas/items/shadow_item.h"

#include <QPainter>
#include <QPainterPath>

namespace view {

namespace {

constexpr double tipRadius = 6;

} // namespace

void ShadowItem::setMarks(const std::optional<ShadowMarks>& marks) {
    if (marks == m_marks) return;
    prepareGeometryChange();
    m_marks = marks;
    update();
}

std::optional<QPointF> ShadowItem::knob() const {
    return m_marks && isVisible() ? std::optional(m_marks->tip) : std::nullopt;
}

void ShadowItem::setHeld(bool held) {
    m_held = held;
    update();
}

QRectF ShadowItem::boundingRect() const {
    if (!m_marks) return {};
    return (QRectF(m_marks->foot, QSizeF(1, 1)) | QRectF(m_marks->tip, QSizeF(1, 1)))
        .adjusted(-12, -12, 12, 12);
}

// A disc, half of which is dark: a pebble in the sun.
void ShadowItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    if (!m_marks) return;
    painter->setRenderHint(QPainter::Antialiasing);
    QPainterPath line(m_marks->foot);
    line.lineTo(m_marks->tip);
    painter->setOpacity(0.8);
    strokeSeen(*painter, line, m_style, m_style.line, 1, Qt::DotLine);
    painter->setOpacity(1);
    const QRectF disc(m_marks->tip.x() - tipRadius, m_marks->tip.y() - tipRadius, 2 * tipRadius,
                      2 * tipRadius);
    painter->setPen(QPen(m_style.rim, 2));
    painter->setBrush(m_held ? m_style.accent : m_style.core);
    painter->drawEllipse(disc);
    painter->setPen(Qt::NoPen);
    painter->setBrush(m_style.rim);
    constexpr int sixteenths = 16; // parts of a degree
    painter->drawChord(disc.adjusted(1, 1, -1, -1), 45 * sixteenths, 180 * sixteenths);
}

} // namespace view
