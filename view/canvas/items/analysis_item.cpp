// SPDX-License-Identifier: MIT
#include "canvas/items/analysis_item.h"

#include "canvas/geometry/canvas_geometry.h"

#include <QPainter>

#include <algorithm>
#include <utility>

namespace view {

namespace {

// The painter's coordinates overflow far outside of the view, where a deep zoom puts most corners.
constexpr double maxCoordinate = 1e6;

QPolygonF toPixels(const attractor::Camera& camera, const ifs::Polygon& points) {
    QPolygonF result;
    for (const auto& point : points) {
        const QPointF pixel = pixelOf(camera, point);
        result.append({std::clamp(pixel.x(), -maxCoordinate, maxCoordinate),
                       std::clamp(pixel.y(), -maxCoordinate, maxCoordinate)});
    }
    return result;
}

} // namespace

QColor outlineColour(document::Outline kind, bool onDark) {
    using document::Outline;
    switch (kind) {
    case Outline::Box:
        return onDark ? QColor(110, 190, 255) : QColor(0, 96, 176);
    case Outline::Hull:
        return onDark ? QColor(255, 190, 70) : QColor(190, 84, 0);
    case Outline::Simplex:
        return onDark ? QColor(120, 225, 150) : QColor(0, 120, 60);
    case Outline::Ellipse:
        return onDark ? QColor(240, 150, 230) : QColor(160, 40, 150);
    case Outline::FixedPoints:
    case Outline::Cylinders:
        break;
    }
    return onDark ? QColor(238, 243, 250) : QColor(30, 40, 58);
}

void AnalysisItem::setShapes(std::vector<document::OutlineShape> shapes) {
    m_shapes = std::move(shapes);
    layoutShapes();
}

void AnalysisItem::setView(const attractor::Camera& camera) {
    m_camera = camera;
    layoutShapes();
}

void AnalysisItem::setStyle(const OverlayStyle& style) {
    OverlayItem::setStyle(style);
    // Keeps thin coloured lines visible on any picture.
    m_style.halo.setAlpha(std::max(230, m_style.halo.alpha()));
}

void AnalysisItem::layoutShapes() {
    prepareGeometryChange();
    m_pixels.clear();
    m_bounds = {};
    for (const auto& shape : m_shapes) {
        m_pixels.push_back(toPixels(m_camera, shape.points));
        // Enlarged, because a rectangle without area would vanish in the union.
        m_bounds |= m_pixels.back().boundingRect().adjusted(-9, -9, 9, 9);
    }
    update();
}

void AnalysisItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    // Limit for halos and thick lines: a drag may draw thousands of cylinders per frame.
    constexpr std::size_t fewToOutline = 200;
    constexpr std::size_t fewToSmooth = 2000;
    const bool many = m_shapes.size() > fewToOutline;
    painter->setRenderHint(QPainter::Antialiasing, m_shapes.size() <= fewToSmooth);
    for (std::size_t k = 0; k < m_shapes.size(); ++k) {
        const auto& shape = m_shapes[k];
        const QColor colour = shape.colour
                                  ? QColor(shape.colour->red, shape.colour->green, shape.colour->blue)
                                  : outlineColour(shape.kind, m_style.onDark);
        const QPolygonF& pixels = m_pixels[k];
        if (pixels.size() == 1 && many) {
            painter->fillRect(QRectF(pixels.front() - QPointF(1.5, 1.5), QSizeF(3, 3)), colour);
            continue;
        }
        if (pixels.size() == 1) {
            painter->setPen(QPen(m_style.rim, 1.5));
            painter->setBrush(colour);
            painter->drawEllipse(pixels.front(), 4.5, 4.5);
            continue;
        }
        painter->setBrush(Qt::NoBrush);
        if (many) {
            painter->setPen(QPen(colour, 1));
            painter->drawPolygon(pixels);
            continue;
        }
        QPainterPath path;
        path.addPolygon(pixels);
        path.closeSubpath();
        strokeWithHalo(*painter, path, m_style, colour, m_style.lineWidth);
    }
}

} // namespace view
