// SPDX-License-Identifier: MIT
#include "canvas/items/readout_item.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>

namespace view {

namespace {

constexpr double readoutPadding = 7;
constexpr double across = 22; // pixels from the pointer, outside the handle and the hand
constexpr double down = 24;
constexpr double readoutMargin = 4; // pixels to the edges of the view
constexpr int readoutFlow = Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap;

} // namespace

void ReadoutItem::setText(const QString& text, const QPointF& pointer) {
    if (m_text == text && m_pointer == pointer) return;
    prepareGeometryChange();
    m_text = text;
    m_pointer = pointer;
    update();
}

void ReadoutItem::setView(const QRectF& view) {
    prepareGeometryChange();
    m_view = view;
}

void ReadoutItem::setFont(const QFont& font) {
    prepareGeometryChange();
    m_font = font;
}

QRectF ReadoutItem::box() const {
    if (m_text.isEmpty()) return {};
    const double room =
        m_view.isEmpty() ? 4000 : std::max(1.0, m_view.width() - 2 * (readoutPadding + readoutMargin) - 1);
    const QRectF text = QFontMetricsF(m_font).boundingRect(QRectF(0, 0, room, 4000), readoutFlow, m_text);
    const QSizeF size(text.width() + 2 * readoutPadding + 1, text.height() + 1.2 * readoutPadding);
    QPointF corner = m_pointer + QPointF(across, down);
    if (corner.x() + size.width() > m_view.right()) corner.setX(m_pointer.x() - across - size.width());
    if (corner.y() + size.height() > m_view.bottom()) corner.setY(m_pointer.y() - down - size.height());
    if (m_view.isEmpty()) return {corner, size};
    // Above or below the pointer if there is room on neither side.
    corner.setX(std::max(m_view.left() + readoutMargin,
                         std::min(corner.x(), m_view.right() - readoutMargin - size.width())));
    corner.setY(std::max(m_view.top() + readoutMargin,
                         std::min(corner.y(), m_view.bottom() - readoutMargin - size.height())));
    return {corner, size};
}

QRectF ReadoutItem::boundingRect() const {
    return box().adjusted(-2, -2, 2, 2);
}

void ReadoutItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    if (m_text.isEmpty()) return;
    painter->setRenderHint(QPainter::Antialiasing);
    const QRectF frame = box();
    painter->setPen(QPen(m_style.gridMajor, 1));
    painter->setBrush(m_style.noteBackground);
    painter->drawRoundedRect(frame, 5, 5);
    painter->setFont(m_font);
    painter->setPen(m_style.noteText);
    painter->drawText(frame.adjusted(readoutPadding, 0, -readoutPadding, 0), readoutFlow, m_text);
}

} // namespace view
