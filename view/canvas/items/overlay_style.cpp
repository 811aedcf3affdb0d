// SPDX-License-Identifier: MIT
#include "canvas/items/overlay_style.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace view {

namespace {

QColor translucent(QColor colour, double opacity) {
    colour.setAlphaF(float(opacity));
    return colour;
}

double luminance(const QColor& colour) {
    const auto linear = [](double v) {
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}

// A desktop that shows text in pure black and white asks for contrast everywhere.
bool wantsHighContrast(const QPalette& palette) {
    const double text = luminance(palette.color(QPalette::WindowText));
    const double window = luminance(palette.color(QPalette::Window));
    return (std::max(text, window) + 0.05) / (std::min(text, window) + 0.05) > 20;
}

} // namespace

OverlayStyle overlayStyle(const attractor::Rgba& background, const QPalette& palette) {
    OverlayStyle style;
    const bool transparent = background.alpha < 255;
    const bool darkDesktop = luminance(palette.color(QPalette::Window)) < 0.18;
    style.backdrop = QColor(background.red, background.green, background.blue);
    if (transparent) {
        style.backdrop = darkDesktop ? QColor(38, 40, 44) : QColor(250, 250, 250);
        style.checker = darkDesktop ? QColor(46, 48, 53) : QColor(236, 237, 239);
    }
    const bool dark = luminance(style.backdrop) < 0.18;
    style.onDark = dark;
    const bool strong = wantsHighContrast(palette);
    const QColor ink = dark ? QColor(214, 224, 240) : QColor(28, 36, 50);
    style.gridMinor = translucent(ink, strong ? 0.18 : 0.055);
    style.gridMajor = translucent(ink, strong ? 0.36 : 0.11);
    style.axis = translucent(ink, strong ? 0.9 : 0.34);
    style.label = translucent(ink, strong ? 1 : 0.55);
    // Black and white, because any colour has a contrast of 4.5 to 1 with one of them; no other two tones
    // have this property.
    const QColor black(0, 0, 0);
    const QColor white(255, 255, 255);
    style.halo = dark ? black : white;
    style.line = dark ? white : black;
    style.core = black;
    style.rim = white;
    style.number = white;
    style.accent = dark ? QColor(150, 255, 30) : QColor(140, 0, 255); // far from the colours of all maps
    style.onAccent = dark ? black : white;
    style.noteBackground = dark ? QColor(28, 34, 46, 232) : QColor(255, 255, 255, 240);
    style.noteText = dark ? QColor(240, 244, 250) : QColor(28, 36, 50);
    style.lineWidth = strong ? 2.5 : 2;
    return style;
}

namespace {

// The lines of a path without curves; none of one with curves.
QList<QLineF> straightLines(const QPainterPath& path) {
    QList<QLineF> lines;
    for (int i = 1; i < path.elementCount(); ++i) {
        if (path.elementAt(i).isCurveTo()) return {};
        if (path.elementAt(i).isLineTo()) lines.append({path.elementAt(i - 1), path.elementAt(i)});
    }
    return lines;
}

// Lines with square ends are filled many times faster than the outline of a path, and they are drawn for
// every move of the pointer. The ends lie under handles.
void stroke(QPainter& painter, const QPainterPath& path, const QColor& colour, double width,
            Qt::PenStyle pattern = Qt::SolidLine) {
    const QList<QLineF> lines = straightLines(path);
    // Other ends would close the gaps, which show the line below.
    const Qt::PenCapStyle cap = pattern != Qt::SolidLine ? Qt::FlatCap
                                : lines.isEmpty()        ? Qt::RoundCap
                                                         : Qt::SquareCap;
    painter.setPen(QPen(colour, width, pattern, cap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    if (lines.isEmpty())
        painter.drawPath(path);
    else
        painter.drawLines(lines);
}

constexpr double haloWidth = 1.5; // pixels on either side

} // namespace

void strokeWithHalo(QPainter& painter, const QPainterPath& path, const OverlayStyle& style,
                    const QColor& colour, double width, Qt::PenStyle pattern) {
    stroke(painter, path, style.halo, width + 2 * haloWidth);
    stroke(painter, path, colour, width, pattern);
}

void strokeSeen(QPainter& painter, const QPainterPath& path, const OverlayStyle& style, const QColor& colour,
                double width, Qt::PenStyle pattern) {
    // A halo shows between dashes; beside a solid line it gets room of its own.
    strokeWithHalo(painter, path, style, style.line,
                   pattern == Qt::SolidLine ? width + 2 * haloWidth : width);
    stroke(painter, path, colour, width, pattern);
}

QList<QLineF> sidesOfFlat(const QPolygonF& outline) {
    constexpr double thin = 7;  // pixels of height that the edges on both sides would cover
    constexpr double aside = 6; // pixels from the middle to either side
    QLineF longest;
    for (const QPointF& a : outline)
        for (const QPointF& b : outline)
            if (QLineF(a, b).length() > longest.length()) longest = {a, b};
    const double length = longest.length();
    if (length < 4 * thin) return {};
    const QLineF normal = longest.unitVector().normalVector();
    const QPointF across(normal.dx(), normal.dy());
    double least = 0, most = 0;
    for (const QPointF& corner : outline) {
        const double height = QPointF::dotProduct(corner - longest.p1(), across);
        least = std::min(least, height);
        most = std::max(most, height);
    }
    if (most - least > thin) return {};
    return {longest.translated(across * (most + aside)), longest.translated(across * (least - aside))};
}

void strokeOutline(QPainter& painter, const QPolygonF& outline, const OverlayStyle& style,
                   const QColor& colour, double width, Qt::PenStyle pattern) {
    constexpr double beside = 2; // pixels; wide enough to cover some pixel wholly at any slope
    double doubledArea = 0;
    double length = 0;
    QList<QLineF> edges;
    for (qsizetype i = 0; i < outline.size(); ++i) {
        const QLineF edge(outline[i], outline[(i + 1) % outline.size()]);
        if (edge.p1() == edge.p2()) continue;
        doubledArea += edge.x1() * edge.y2() - edge.x2() * edge.y1();
        length += edge.length();
        edges.append(edge);
    }
    QPainterPath path;
    if (const QList<QLineF> sides = sidesOfFlat(outline); !sides.isEmpty()) {
        for (const QLineF& side : sides) {
            path.moveTo(side.p1());
            path.lineTo(side.p2());
        }
        strokeSeen(painter, path, style, colour, width, pattern);
        return;
    }
    path.addPolygon(outline);
    path.closeSubpath();
    if (std::abs(doubledArea) < 2 * beside * length) { // too flat to have an inside
        strokeSeen(painter, path, style, colour, width, pattern);
        return;
    }
    const double outwards = std::copysign((width + beside) / 2, -doubledArea);
    const auto shifted = [&edges](double by) {
        QList<QLineF> lines;
        for (const QLineF& edge : edges) {
            // Anticlockwise on the screen, where y points down.
            const QLineF normal = edge.unitVector().normalVector();
            lines.append(edge.translated(-by * normal.dx(), -by * normal.dy()));
        }
        return lines;
    };
    painter.setPen(QPen(style.line, beside, Qt::SolidLine, Qt::FlatCap));
    painter.drawLines(shifted(-outwards));
    painter.setPen(QPen(style.halo, beside, Qt::SolidLine, Qt::SquareCap));
    painter.drawLines(shifted(outwards));
    if (pattern != Qt::SolidLine) stroke(painter, path, style.halo, width);
    stroke(painter, path, colour, width, pattern);
}

void strokeLit(QPainter& painter, const QPainterPath& path, const OverlayStyle& style, double width,
               Qt::PenStyle pattern) {
    strokeSeen(painter, path, style, style.accent, width, pattern);
}

void strokeFocusRing(QPainter& painter, const QPointF& centre, double radius, const OverlayStyle& style) {
    QPainterPath ring;
    ring.addEllipse(centre, radius, radius);
    strokeWithHalo(painter, ring, style, style.accent, style.lineWidth + 0.5);
}

} // namespace view
