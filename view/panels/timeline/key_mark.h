// SPDX-License-Identifier: MIT
#pragma once

#include "animation/keys/ease.h"

#include <QColor>
#include <QPolygonF>

class QPainter;
class QPalette;

// Drawing of keys in the timeline.
namespace view {

QColor faded(QColor colour, double share);
QPolygonF diamond(const QPointF& middle, double half);

// Paints with the painter's pen and brush: a diamond, or a circle where the motion goes on without a corner.
void paintKeyMark(QPainter& painter, const QPointF& middle, const animation::Ease& ease);

// A red bar below `top`: something is wrong at this frame.
void paintFlaw(QPainter& painter, const QPointF& top, double height, const QPalette& palette);

} // namespace view
