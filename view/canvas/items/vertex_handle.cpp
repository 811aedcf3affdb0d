// SPDX-License-Identifier: MIT
#include "canvas/items/vertex_handle.h"

#include <QPainter>

namespace view {

namespace {

constexpr double vertexRadius = 9;
constexpr double vertexFocusRadius = 14;

} // namespace

VertexHandle::VertexHandle(int number, QGraphicsItem* parent) : OverlayItem(parent), m_number(number) {}

void VertexHandle::setState(HandleStates state) {
    if (m_state == state) return;
    m_state = state;
    update();
}

QRectF VertexHandle::boundingRect() const {
    constexpr double extent = vertexFocusRadius + 3;
    return {-extent, -extent, 2 * extent, 2 * extent};
}

void VertexHandle::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    painter->setRenderHint(QPainter::Antialiasing);
    if (m_state.testFlag(HandleState::Focused))
        strokeFocusRing(*painter, QPointF(), vertexFocusRadius, m_style);
    const bool lit =
        m_state & (HandleStates(HandleState::Hovered) | HandleState::Pressed | HandleState::Selected);
    const double grown = m_state.testFlag(HandleState::Hovered) ? vertexRadius + 1 : vertexRadius;
    QColor core = m_style.core;
    if (m_state.testFlag(HandleState::Hidden) && !lit) core.setAlphaF(0.4F); // hollow, with a readable number
    painter->setPen(Qt::NoPen);
    painter->setBrush(core);
    painter->drawEllipse(QPointF(), grown + 2, grown + 2);
    painter->setBrush(lit ? m_style.accent : core);
    painter->setPen(QPen(m_style.rim, m_style.lineWidth));
    painter->drawEllipse(QPointF(), grown - 0.5, grown - 0.5);

    if (m_number == 0) return;
    QFont font = painter->font();
    font.setPixelSize(m_number < 10 ? 11 : 9);
    font.setBold(true);
    painter->setFont(font);
    painter->setPen(lit ? m_style.onAccent : m_style.number);
    painter->drawText(QRectF(-12, -12, 24, 24), Qt::AlignCenter, QString::number(m_number));
}

} // namespace view
