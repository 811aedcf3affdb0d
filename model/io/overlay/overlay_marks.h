// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "document/fractal/fractal.h"

#include <QColor>
#include <QPolygonF>
#include <QString>

#include <vector>

class QPainter;

// The shapes that are drawn over a picture, whatever kind of file it is written to. Lengths are pixels, y is
// down.
namespace io {

// A polygon, a disc or a word, in this order of preference: empty ones are not drawn.
struct OverlayMark {
    QPolygonF polygon;
    QPointF centre; // centre of the disc and of the word
    double radius = 0;
    QString word; // bold
    double letterSize = 0;
    QColor fill;   // colour of the word, if any; invalid: none
    QColor stroke; // invalid: none
    double width = 0;
    QList<qreal> dashes{}; // multiples of the line width
    Qt::PenCapStyle cap = Qt::RoundCap;
};
using OverlayMarks = std::vector<OverlayMark>;

void paint(QPainter& painter, const OverlayMarks& marks);

QColor cageColour();
QColor inkOn(const attractor::Rgba& background);  // colour of lines that are seen on it
QColor haloOn(const attractor::Rgba& background); // colour behind them
// The corners of the cage with their numbers, as on the canvas, on this background.
OverlayMarks cornerMarks(const document::Fractal& fractal, const attractor::Camera& camera,
                         const attractor::Rgba& background);
// The control polygon, the rest polygon dashed where it differs.
OverlayMarks cageMarks(const document::Fractal& fractal, const attractor::Camera& camera,
                       const QColor& colour = cageColour());

} // namespace io
