// SPDX-License-Identifier: MIT
#include "io/overlay/cage_overlay.h"

#include "document/fractal_geometry.h"

#include <QPainter>
#include <QPen>
#include <QPolygonF>

#include <algorithm>

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

} // namespace

QColor cageColour() {
    return {245, 166, 35};
}

void paintCage(QImage& rows, const document::Fractal& fractal, const attractor::Camera& camera,
               int firstRow) {
    const ifs::ControlCage<2> cage = document::effectiveCage(fractal);
    QPainter painter(&rows);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(0, -firstRow);
    QPen pen(cageColour(), std::max(1.5, std::min(camera.width, camera.height) / 500.0));
    pen.setJoinStyle(Qt::RoundJoin);
    if (cage.rest != cage.current) {
        QPen dashed = pen;
        dashed.setDashPattern({4, 4});
        painter.setPen(dashed);
        painter.drawPolygon(onScreen(cage.rest, camera));
    }
    painter.setPen(pen);
    painter.drawPolygon(onScreen(cage.current, camera));
}

} // namespace io
