// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/colour/palette.h"

#include <QColor>
#include <QPalette>
#include <QPointF>
#include <QPolygonF>

class QPainter;
class QPainterPath;

namespace view {

// Colours of everything drawn over the picture. They follow the background of the picture, not only the
// desktop's palette: a handle must be visible on both.
struct OverlayStyle {
    QColor backdrop; // background of the picture
    QColor checker;  // other squares behind a transparent picture; invalid if it is opaque
    QColor gridMinor;
    QColor gridMajor;
    QColor axis;
    QColor label;
    QColor halo; // wide line under every line
    QColor line; // cage and gizmo
    QColor core; // inside of a handle
    QColor rim;
    QColor number;
    QColor accent;   // hover, selection, focus, snap
    QColor onAccent; // text on the accent
    QColor noteBackground;
    QColor noteText;
    double lineWidth = 2;
    bool onDark = false; // true for a dark backdrop
};

OverlayStyle overlayStyle(const attractor::Rgba& background, const QPalette& palette);

// A line in the halo.
void strokeWithHalo(QPainter& painter, const QPainterPath& path, const OverlayStyle& style,
                    const QColor& colour, double width, Qt::PenStyle pattern = Qt::SolidLine);

// A line that is seen on any picture whatever its colour: it lies on a line in the halo.
void strokeSeen(QPainter& painter, const QPainterPath& path, const OverlayStyle& style, const QColor& colour,
                double width, Qt::PenStyle pattern = Qt::SolidLine);

// The same for a closed outline, and thinner: the halo is outside, the colour of lines inside.
// The two long sides of a strip around an outline that is too flat to have an inside, so that what lies on it
// is seen between them; empty where it is not flat.
QList<QLineF> sidesOfFlat(const QPolygonF& outline);

void strokeOutline(QPainter& painter, const QPolygonF& outline, const OverlayStyle& style,
                   const QColor& colour, double width, Qt::PenStyle pattern = Qt::SolidLine);

// A line that is seen on any picture, in the accent colour.
void strokeLit(QPainter& painter, const QPainterPath& path, const OverlayStyle& style, double width,
               Qt::PenStyle pattern = Qt::SolidLine);

// Draws a ring around the handle that the keyboard moves.
void strokeFocusRing(QPainter& painter, const QPointF& centre, double radius, const OverlayStyle& style);

} // namespace view
