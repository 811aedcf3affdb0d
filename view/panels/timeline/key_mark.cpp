// SPDX-License-Identifier: MIT
#include "panels/timeline/key_mark.h"

#include <QPainter>

namespace view {

namespace {

constexpr double diamondHalf = 6;
constexpr double radius = 5; // about as much ink

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

} // namespace view
