// SPDX-License-Identifier: MIT
#pragma once

#include <QRectF>

class QColor;
class QPainter;

// The signs of layers, drawn in the colour of the text beside them.
namespace view {

enum class Eye { Open, Closed };
void paintEye(QPainter& painter, const QRectF& cell, const QColor& colour, Eye eye);

enum class Padlock { Closed, Open };
void paintPadlock(QPainter& painter, const QRectF& cell, const QColor& colour, Padlock padlock);

} // namespace view
