// SPDX-License-Identifier: MIT
#include "canvas/note_item.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>

namespace view {

namespace {

constexpr double padding = 10;
constexpr double margin = 14;
constexpr double widest = 560;
constexpr int flow = Qt::AlignCenter | Qt::TextWordWrap;

} // namespace

void NoteItem::setText(const QString& text) {
    if (m_text == text) return;
    prepareGeometryChange();
    m_text = text;
    update();
}

void NoteItem::setView(const QRectF& view) {
    prepareGeometryChange();
    m_view = view;
}

void NoteItem::setFont(const QFont& font) {
    prepareGeometryChange();
    m_font = font;
}

QRectF NoteItem::box() const {
    if (m_text.isEmpty()) return {};
    const double width = std::max(80.0, std::min(widest, m_view.width() - 2 * (margin + padding)));
    QRectF text = QFontMetricsF(m_font).boundingRect(QRectF(0, 0, width, 4000), flow, m_text);
    text = QRectF(0, 0, text.width() + 1, text.height() + 1)
               .adjusted(-padding, -padding * 0.7, padding, padding * 0.7);
    const double x = m_view.center().x() - text.width() / 2;
    const double y = m_place == Place::Top ? m_view.top() + margin : m_view.bottom() - margin - text.height();
    return {x, y, text.width(), text.height()};
}

QRectF NoteItem::boundingRect() const {
    return box().adjusted(-2, -2, 2, 2);
}

void NoteItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    if (m_text.isEmpty()) return;
    painter->setRenderHint(QPainter::Antialiasing);
    const QRectF frame = box();
    painter->setPen(QPen(m_style.gridMajor, 1));
    painter->setBrush(m_style.noteBackground);
    painter->drawRoundedRect(frame, 7, 7);
    painter->setFont(m_font);
    painter->setPen(m_style.noteText);
    painter->drawText(frame.adjusted(padding, 0, -padding, 0), flow, m_text);
}

} // namespace view
