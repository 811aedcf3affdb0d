// SPDX-License-Identifier: MIT
#include "canvas/items/note_item.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>

namespace view {

namespace {

constexpr double notePadding = 10;
constexpr double noteMargin = 14;
constexpr double crossSize = 4;  // pixels; half the size of the cross that dismisses a note
constexpr double crossRoom = 18; // pixels beside the sentence
constexpr double widest = 560;
constexpr double reach = 12; // pixels around the middle of a handle
constexpr int places = 30;   // places in the middle, left and right, in rows from the edge on
constexpr int noteFlow = Qt::AlignCenter | Qt::TextWordWrap;

} // namespace

void NoteItem::setText(const QString& text) {
    if (m_text == text) return;
    prepareGeometryChange();
    m_text = text;
    choosePlace();
    update();
}

void NoteItem::setDismissible(bool dismissible) {
    if (m_isDismissible == dismissible) return;
    prepareGeometryChange();
    m_isDismissible = dismissible;
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

void NoteItem::avoid(std::vector<QPointF> points, const QRectF& other) {
    m_points = std::move(points);
    m_other = other;
    choosePlace();
}

int NoteItem::obstaclesAt(int place) const {
    const QRectF box = boxAt(place).adjusted(-reach, -reach, reach, reach);
    const auto hidden = std::ranges::count_if(m_points, [&](const QPointF& p) { return box.contains(p); });
    return int(hidden) + (box.intersects(m_other) ? 1000 : 0) + (m_view.contains(boxAt(place)) ? 0 : 1000);
}

// Stays where it is as long as nothing is in its way.
void NoteItem::choosePlace() {
    if (m_text.isEmpty()) {
        m_place = 0;
        return;
    }
    int best = m_place;
    for (int place = 0; place < places && obstaclesAt(best) > 0; ++place)
        if (obstaclesAt(place) < obstaclesAt(best)) best = place;
    if (best == m_place) return;
    prepareGeometryChange();
    m_place = best;
    update();
}

QRectF NoteItem::box() const {
    return boxAt(m_place);
}

QRectF NoteItem::boxAt(int place) const {
    if (m_text.isEmpty()) return {};
    const double width = std::max(80.0, std::min(widest, m_view.width() - 2 * (noteMargin + notePadding)));
    QRectF text = QFontMetricsF(m_font).boundingRect(QRectF(0, 0, width, 4000), noteFlow, m_text);
    text = QRectF(0, 0, text.width() + 1, text.height() + 1)
               .adjusted(-notePadding, -notePadding * 0.7, notePadding, notePadding * 0.7);
    if (m_isDismissible) text.setWidth(text.width() + 2 * crossRoom); // keeps the sentence centred
    const double left = m_view.left() + noteMargin, right = m_view.right() - noteMargin - text.width();
    const int row = place / 3, column = place % 3;
    const double x = column == 0 ? m_view.center().x() - text.width() / 2 : column == 1 ? left : right;
    const double inwards = noteMargin + row * text.height();
    const double y = m_edge == Edge::Top ? m_view.top() + inwards : m_view.bottom() - inwards - text.height();
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
    const double aside = notePadding + (m_isDismissible ? crossRoom : 0);
    painter->drawText(frame.adjusted(aside, 0, -aside, 0), noteFlow, m_text);
    if (!m_isDismissible) return;
    const QPointF middle(frame.right() - notePadding - crossSize, frame.center().y());
    painter->setPen(QPen(m_style.noteText, 1.5, Qt::SolidLine, Qt::RoundCap));
    painter->drawLine(middle - QPointF(crossSize, crossSize), middle + QPointF(crossSize, crossSize));
    painter->drawLine(middle - QPointF(crossSize, -crossSize), middle + QPointF(crossSize, -crossSize));
}

} // namespace view
