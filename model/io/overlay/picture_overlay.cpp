// SPDX-License-Identifier: MIT
#include "io/overlay/picture_overlay.h"

#include "document/map_handles.h"
#include "ifs/extent/convex_hull.h"
#include "io/overlay/cage_overlay.h"

#include <QFont>
#include <QPainter>
#include <QPen>

#include <algorithm>
#include <cmath>
#include <memory>

namespace io {

namespace {

QColor colourOf(const attractor::Rgba& colour) {
    return {colour.red, colour.green, colour.blue};
}

bool isDark(const attractor::Rgba& background) {
    return background.alpha == 255 && qGray(background.red, background.green, background.blue) < 128;
}

QPen joined(const QColor& colour, double width) {
    QPen pen(colour, width);
    pen.setJoinStyle(Qt::RoundJoin);
    pen.setCapStyle(Qt::RoundCap);
    return pen;
}

QPointF middleOf(const QPolygonF& polygon) {
    QPointF sum;
    for (const QPointF& point : polygon)
        sum += point;
    return sum / double(std::max<qsizetype>(1, polygon.size()));
}

} // namespace

OverlayShapes::OverlayShapes(const document::Fractal& fractal, const attractor::Camera& camera,
                             const PictureOverlay& overlay)
    : m_camera(camera),
      m_overlay(overlay),
      m_fractal(fractal),
      m_width(std::max(1.5, std::min(camera.width, camera.height) / 500.0)) {
    const bool onDark = isDark(fractal.appearance.background);
    m_ink = onDark ? QColor(214, 224, 240) : QColor(28, 36, 50);
    m_halo = onDark ? QColor(0, 0, 0) : QColor(255, 255, 255);
    if (overlay.maps || overlay.fixedPoints || overlay.numbers) addMaps(fractal);
    if (overlay.hull) addHull(fractal);
}

QPointF OverlayShapes::onScreen(const ifs::Vector<2>& displayed) const {
    const ifs::Vector<2> pixel = toPixel(m_camera, displayed);
    return {pixel.x(), pixel.y()};
}

void OverlayShapes::addMaps(const document::Fractal& fractal) {
    const document::MapHandles handles(std::make_shared<document::Fractal>(fractal),
                                       document::effectiveCage(fractal));
    const ifs::Placement placement = document::placement(fractal);
    const auto& maps = handles.maps();
    const std::vector<double> probabilities = ifs::probabilities(*document::system2(fractal));
    for (std::size_t i = 0; i < maps.size(); ++i) {
        Map map{i + 1, {}, colourOf(mapColour(fractal.appearance, maps[i].id, i)), probabilities[i] > 0,
                false, {}};
        for (const ifs::Vector<2>& corner : handles.outline(i))
            map.image << onScreen(corner);
        if (const auto point = ifs::fixedPoint(maps[i].map)) {
            map.hasFixedPoint = true;
            map.fixedPoint = onScreen(placement(*point));
        }
        m_maps.push_back(std::move(map));
    }
}

// Within a tenth of a pixel, and bent with the cage.
void OverlayShapes::addHull(const document::Fractal& fractal) {
    constexpr int parts = 16; // of an edge that bends
    const auto support = document::supportFunction(fractal);
    if (!support) return;
    const ifs::Placement placement = document::placement(fractal);
    const double size = std::max(1e-300, ifs::spectralNorm(placement.affine().linear));
    const auto hull = ifs::convexHull(*support, 0.1 / (size * m_camera.pixelsPerUnit));
    const int steps = placement.bend() ? parts : 1;
    for (std::size_t i = 0; i < hull.vertices.size(); ++i) {
        const ifs::Vector<2>& from = hull.vertices[i];
        const ifs::Vector<2> edge = hull.vertices[(i + 1) % hull.vertices.size()] - from;
        for (int k = 0; k < steps; ++k)
            m_hull << onScreen(placement(from + edge * (double(k) / steps)));
    }
}

void OverlayShapes::paintMap(QPainter& painter, const Map& map) const {
    QColor tint = map.colour;
    tint.setAlphaF(0.08F);
    painter.setBrush(tint);
    painter.setPen(joined(m_halo, 2 * m_width));
    painter.drawPolygon(map.image);
    painter.setBrush(Qt::NoBrush);
    QPen pen = joined(map.colour, m_width);
    if (!map.takesPart) pen.setDashPattern({4, 3});
    painter.setPen(pen);
    painter.drawPolygon(map.image);
}

void OverlayShapes::paintFixedPoint(QPainter& painter, const Map& map) const {
    const double radius = 3 * m_width;
    painter.setPen(QPen(m_halo, m_width));
    painter.setBrush(map.colour);
    painter.drawEllipse(map.fixedPoint, radius, radius);
    painter.setPen(QPen(m_ink, m_width / 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(map.fixedPoint, radius + m_width / 2, radius + m_width / 2);
}

void OverlayShapes::paintNumber(QPainter& painter, const Map& map) const {
    const double radius = 7.5 * m_width;
    const QPointF middle = middleOf(map.image);
    painter.setPen(QPen(m_halo, m_width));
    painter.setBrush(map.colour);
    painter.drawEllipse(middle, radius, radius);
    QFont font;
    const QString text = QString::number(map.number);
    font.setPixelSize(std::max(6, int(std::lround(radius * (text.size() < 3 ? 1.1 : 0.8)))));
    font.setBold(true);
    painter.setFont(font);
    painter.setPen(qGray(map.colour.rgb()) > 130 ? QColor(14, 18, 26) : QColor(250, 252, 255));
    painter.drawText(QRectF(middle.x() - 2 * radius, middle.y() - radius, 4 * radius, 2 * radius),
                     int(Qt::AlignCenter) | Qt::TextDontClip, text);
}

void OverlayShapes::paint(QImage& rows, int firstRow) const {
    QPainter painter(&rows);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    painter.translate(0, -firstRow);
    if (m_overlay.maps)
        for (const Map& map : m_maps)
            paintMap(painter, map);
    if (!m_hull.isEmpty()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(joined(m_halo, 2 * m_width));
        painter.drawPolygon(m_hull);
        painter.setPen(joined(m_ink, m_width));
        painter.drawPolygon(m_hull);
    }
    if (m_overlay.cage) {
        painter.end();
        paintCage(rows, m_fractal, m_camera, firstRow);
        painter.begin(&rows);
        painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
        painter.translate(0, -firstRow);
    }
    if (m_overlay.fixedPoints)
        for (const Map& map : m_maps)
            if (map.hasFixedPoint) paintFixedPoint(painter, map);
    if (m_overlay.numbers)
        for (const Map& map : m_maps)
            paintNumber(painter, map);
}

} // namespace io
