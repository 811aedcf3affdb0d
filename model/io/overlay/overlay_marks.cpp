// SPDX-License-Identifier: MIT
#include "io/overlay/overlay_marks.h"

#include "document/fractal/fractal_geometry.h"

#include <QFont>
#include <QPainter>
#include <QPen>

#include <algorithm>
#include <cmath>

namespace io {

namespace {

QPolygonF onScreen(const std::vector<ifs::Vector<2>>& vertices, const attractor::Camera& camera) {
    QPolygonF polygon;
    for (const auto& vertex : vertices) {
        const auto pixel = toPixel(camera, vertex);
        polygon << QPointF(pixel.x(), pixel.y());
    }
    return polygon;
}

QPen penOf(const OverlayMark& mark) {
    if (!mark.stroke.isValid()) return Qt::NoPen;
    QPen pen(mark.stroke, mark.width);
    pen.setJoinStyle(Qt::RoundJoin);
    pen.setCapStyle(mark.cap);
    if (!mark.dashes.isEmpty()) pen.setDashPattern(mark.dashes);
    return pen;
}

void paintWord(QPainter& painter, const OverlayMark& mark) {
    QFont font;
    font.setPixelSize(std::max(6, int(std::lround(mark.letterSize))));
    font.setBold(true);
    painter.setFont(font);
    painter.setPen(mark.fill);
    const double reach = 2 * mark.letterSize;
    painter.drawText(QRectF(mark.centre.x() - 2 * reach, mark.centre.y() - reach, 4 * reach, 2 * reach),
                     int(Qt::AlignCenter) | Qt::TextDontClip, mark.word);
}

} // namespace

void paint(QPainter& painter, const OverlayMarks& marks) {
    for (const OverlayMark& mark : marks) {
        painter.setPen(penOf(mark));
        painter.setBrush(mark.fill.isValid() ? QBrush(mark.fill) : QBrush(Qt::NoBrush));
        if (!mark.polygon.isEmpty())
            painter.drawPolygon(mark.polygon);
        else if (mark.radius > 0)
            painter.drawEllipse(mark.centre, mark.radius, mark.radius);
        else if (!mark.word.isEmpty())
            paintWord(painter, mark);
    }
}

static bool isDark(const attractor::Rgba& background) {
    return background.alpha == 255 && qGray(background.red, background.green, background.blue) < 128;
}

QColor inkOn(const attractor::Rgba& background) {
    return isDark(background) ? QColor(214, 224, 240) : QColor(28, 36, 50);
}

QColor haloOn(const attractor::Rgba& background) {
    return isDark(background) ? Qt::black : Qt::white;
}

OverlayMarks cornerMarks(const document::Fractal& fractal, const attractor::Camera& camera,
                         const attractor::Rgba& background) {
    constexpr double share = 0.018; // of the height of the picture
    const ifs::ControlCage<2> cage = document::effectiveCage(fractal);
    OverlayMarks marks;
    for (std::size_t i = 0; i < cage.current.size(); ++i) {
        const ifs::Vector<2> pixel = attractor::toPixel(camera, cage.current[i]);
        OverlayMark disc;
        disc.centre = {pixel.x(), pixel.y()};
        disc.radius = std::max(6.0, share * camera.height);
        disc.fill = haloOn(background);
        disc.stroke = inkOn(background);
        disc.width = disc.radius / 6;
        OverlayMark digits;
        digits.centre = disc.centre;
        digits.word = QString::number(i + 1);
        digits.letterSize = 1.1 * disc.radius;
        digits.fill = disc.stroke;
        marks.push_back(std::move(disc));
        marks.push_back(std::move(digits));
    }
    return marks;
}

QColor cageColour() {
    return {245, 166, 35};
}

OverlayMarks cageMarks(const document::Fractal& fractal, const attractor::Camera& camera,
                       const QColor& colour) {
    const ifs::ControlCage<2> cage = document::effectiveCage(fractal);
    OverlayMark mark;
    mark.stroke = colour;
    mark.width = std::max(1.5, std::min(camera.width, camera.height) / 500.0);
    mark.cap = Qt::SquareCap;
    OverlayMarks marks;
    if (cage.rest != cage.current) {
        mark.polygon = onScreen(cage.rest, camera);
        mark.dashes = {4, 4};
        marks.push_back(mark);
    }
    mark.polygon = onScreen(cage.current, camera);
    mark.dashes.clear();
    marks.push_back(mark);
    return marks;
}

} // namespace io
