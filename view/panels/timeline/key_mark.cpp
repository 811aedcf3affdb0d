// SPDX-License-Identifier: MIT
#include "panels/timeline/key_mark.h"

#include <QPainter>
#include <QPalette>

namespace view {

namespace {

constexpr double diamondHalf = 6;
constexpr double radius = 5; // similar amount of ink

} // namespace

QColor faded(QColor colour, double share) {
    colour.setAlphaF(float(colour.alphaF() * share));
    return colour;
}

QPolygonF diamond(const QPointF& middle, double half) {
    return QPolygonF({middle + QPointF(0, -half), middle + QPointF(half, 0), middle + QPointF(0, half),
                      middle + QPointF(-half, 0)});
}

void paintKeyMark(QPainter& painter, const QPointF& middle, const animation::Ease& ease) {
    if (ease.kind == animation::Ease::Kind::Smooth)
        painter.drawEllipse(middle, radius, radius);
    else
        painter.drawPolygon(diamond(middle, diamondHalf));
}

void paintFlaw(QPainter& painter, const QPointF& top, double height, const QPalette& palette) {
    const bool isDark = palette.color(QPalette::Window).lightness() < 128;
    painter.setPen(Qt::NoPen);
    painter.setBrush(isDark ? QColor(255, 107, 107) : QColor(200, 40, 40));
    painter.drawRect(QRectF(top.x() - 2, top.y(), 4, height));
}

} // namespace view
