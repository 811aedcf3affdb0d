// SPDX-License-Identifier: MIT
#include "canvas/items/canvas_marks.h"

#include <QPainter>
#include <QPainterPath>

namespace view {

namespace {

constexpr double guide = 28; // pixels to either side

} // namespace

void SnapMark::setSnap(const std::optional<Snapped>& snap, const QPointF& pixel) {
    m_snap = snap && (snap->x || snap->y) ? snap : std::nullopt;
    setPos(pixel);
    update();
}

QRectF SnapMark::boundingRect() const {
    constexpr double extent = guide + 3;
    return {-extent, -extent, 2 * extent, 2 * extent};
}

void SnapMark::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    if (!m_snap) return;
    painter->setRenderHint(QPainter::Antialiasing);
    QPainterPath mark;
    if (m_snap->vertex) {
        mark.addEllipse(QPointF(), 15, 15);
    } else {
        for (const double way : {-1.0, 1.0}) {
            if (m_snap->x) {
                mark.moveTo(0, way * 13);
                mark.lineTo(0, way * guide);
            }
            if (m_snap->y) {
                mark.moveTo(way * 13, 0);
                mark.lineTo(way * guide, 0);
            }
        }
    }
    strokeLit(*painter, mark, m_style, m_style.lineWidth);
}

void RubberItem::setPoints(const QPolygonF& clicked, const std::optional<QPointF>& pointer) {
    prepareGeometryChange();
    m_clicked = clicked;
    m_pointer = pointer;
    update();
}

QRectF RubberItem::boundingRect() const {
    QPolygonF all = m_clicked;
    if (m_pointer) all.append(*m_pointer);
    return all.boundingRect().adjusted(-14, -14, 14, 14);
}

void RubberItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    if (m_clicked.isEmpty()) return;
    painter->setRenderHint(QPainter::Antialiasing);
    QPainterPath lines;
    lines.addPolygon(m_clicked);
    if (m_pointer) {
        lines.lineTo(*m_pointer);
        lines.closeSubpath();
    }
    strokeLit(*painter, lines, m_style, m_style.lineWidth, Qt::DashLine);
    QFont font = painter->font();
    font.setPixelSize(11);
    font.setBold(true);
    painter->setFont(font);
    for (int i = 0; i < m_clicked.size(); ++i) {
        painter->setPen(QPen(m_style.rim, m_style.lineWidth));
        painter->setBrush(m_style.core);
        painter->drawEllipse(m_clicked[i], 9, 9);
        painter->setPen(m_style.number);
        painter->drawText(QRectF(m_clicked[i] - QPointF(12, 12), QSizeF(24, 24)), Qt::AlignCenter,
                          QString::number(i + 1));
    }
}

void BandItem::setBand(const QRectF& band) {
    prepareGeometryChange();
    m_band = band;
    update();
}

QRectF BandItem::boundingRect() const {
    return m_band.adjusted(-2, -2, 2, 2);
}

void BandItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    if (m_band.isEmpty()) return;
    QColor fill = m_style.accent;
    fill.setAlphaF(0.12F);
    painter->fillRect(m_band, fill);
    // A thin line of black and white dashes, visible on any picture.
    painter->setBrush(Qt::NoBrush);
    painter->setPen(QPen(m_style.halo, 1));
    painter->drawRect(m_band);
    QPen dashes(m_style.line, 1, Qt::CustomDashLine, Qt::FlatCap);
    dashes.setDashPattern({4, 4});
    painter->setPen(dashes);
    painter->drawRect(m_band);
}

} // namespace view
