// SPDX-License-Identifier: MIT
#include "panels/maps/layer_signs.h"

#include <QColor>
#include <QPainter>
#include <QPainterPath>

namespace view {

namespace {

void usePen(QPainter& painter, const QColor& colour) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colour, 1.3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
}

} // namespace

void paintEye(QPainter& painter, const QRectF& cell, const QColor& colour, Eye eye) {
    const QPointF middle = cell.center();
    constexpr qreal half = 6.5, lid = 6;
    painter.save();
    usePen(painter, colour);
    QPainterPath almond(middle - QPointF(half, 0));
    if (eye == Eye::Open) {
        almond.quadTo(middle - QPointF(0, lid + 2), middle + QPointF(half, 0));
        almond.quadTo(middle + QPointF(0, lid + 2), middle - QPointF(half, 0));
        painter.drawPath(almond);
        painter.setBrush(colour);
        painter.setPen(Qt::NoPen);
        painter.drawEllipse(middle, 2, 2);
    } else { // lower lid with its lashes
        almond.quadTo(middle + QPointF(0, lid), middle + QPointF(half, 0));
        painter.drawPath(almond);
        painter.drawLine(middle + QPointF(0, 3.2), middle + QPointF(0, 5.2));
        for (const int side : {-1, 1})
            painter.drawLine(middle + QPointF(side * 3.4, 2.4), middle + QPointF(side * 4.4, 4.2));
    }
    painter.restore();
}

void paintPadlock(QPainter& painter, const QRectF& cell, const QColor& colour, Padlock padlock) {
    const QPointF middle = cell.center();
    const bool isOpen = padlock == Padlock::Open;
    painter.save();
    usePen(painter, colour);
    const QRectF shackle(middle.x() - 2.5 + (isOpen ? 4.5 : 0), middle.y() - 5.5, 5, 6);
    QPainterPath bow;
    bow.moveTo(shackle.left(), middle.y() - 0.5);
    bow.lineTo(shackle.left(), shackle.top() + 2.5);
    bow.arcTo(QRectF(shackle.left(), shackle.top(), 5, 5), 180, -180);
    if (!isOpen) bow.lineTo(shackle.right(), middle.y() - 0.5);
    painter.drawPath(bow);
    const QRectF body(middle.x() - 4, middle.y() - 0.5, 8, 6);
    if (!isOpen) painter.setBrush(colour);
    painter.drawRoundedRect(body, 1.2, 1.2);
    painter.restore();
}

} // namespace view
