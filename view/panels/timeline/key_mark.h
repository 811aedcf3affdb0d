// SPDX-License-Identifier: MIT
#pragma once

#include "animation/ease.h"

#include <QColor>
#include <QPolygonF>

class QPainter;

// How keys look in the timeline.
namespace view {

QColor faded(QColor colour, double share);
QPolygonF diamond(const QPointF& middle, double half);

// With the pen and brush of the painter: a diamond, or a circle where the motion goes on without a corner.
void paintKeyMark(QPainter& painter, const QPointF& middle, const animation::Ease& ease);

} // namespace view
