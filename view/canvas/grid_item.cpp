// SPDX-License-Identifier: MIT
#include "canvas/grid_item.h"

#include "canvas/canvas_geometry.h"
#include "canvas/grid_spacing.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace view {

namespace {

// Lines k·step for first ≤ k ≤ last; none where the numbers are too coarse to tell neighbours apart.
struct Lines {
    double first = 0;
    double last = -1;
};

Lines linesBetween(double a, double b, double step) {
    const double low = std::min(a, b) / step;
    const double high = std::max(a, b) / step;
    if (std::max(std::abs(low), std::abs(high)) > 4e15) return {};
    return {std::ceil(low), std::floor(high)};
}

// On the middle of a device pixel, where a thin line stays thin.
double crisp(double pixel, double ratio) {
    return (std::floor(pixel * ratio) + 0.5) / ratio;
}

QFont labelFont(const QPainter& painter) {
    QFont font = painter.font();
    font.setPointSizeF(std::max(7.0, font.pointSizeF() - 1.5));
    return font;
}

} // namespace

void GridItem::setView(const attractor::Camera& camera) {
    if (camera.width != m_camera.width || camera.height != m_camera.height) prepareGeometryChange();
    m_camera = camera;
    update();
}

void GridItem::setGridVisible(bool visible) {
    m_grid = visible;
    update();
}

void GridItem::setAxesVisible(bool visible) {
    m_axes = visible;
    update();
}

QRectF GridItem::boundingRect() const {
    return {0, 0, double(m_camera.width), double(m_camera.height)};
}

void GridItem::paintGrid(QPainter& painter) const {
    const GridSpacing spacing = gridSpacing(m_camera.pixelsPerUnit);
    const double ratio = painter.device()->devicePixelRatioF();
    const ifs::Vector<2> corner = worldAt(m_camera, QPointF(0, 0));
    const ifs::Vector<2> opposite = worldAt(m_camera, QPointF(m_camera.width, m_camera.height));
    QList<QLineF> minor;
    QList<QLineF> major;
    const auto collect = [&](int axis) {
        const Lines lines = linesBetween(corner[axis], opposite[axis], spacing.minor);
        for (double k = lines.first; k <= lines.last; ++k) {
            if (k == 0 && m_axes) continue;
            QList<QLineF>& lineup = std::fmod(k, spacing.subdivisions) == 0 ? major : minor;
            ifs::Vector<2> world = m_camera.centre;
            world[axis] = k * spacing.minor;
            const ifs::Vector<2> pixel = attractor::toPixel(m_camera, world);
            const double at = crisp(pixel[axis], ratio);
            lineup.append(axis == 0 ? QLineF(at, 0, at, m_camera.height) : QLineF(0, at, m_camera.width, at));
        }
    };
    collect(0);
    collect(1);
    painter.setPen(QPen(m_style.gridMinor, 1 / ratio));
    painter.drawLines(minor);
    painter.setPen(QPen(m_style.gridMajor, 1 / ratio));
    painter.drawLines(major);
}

void GridItem::paintAxes(QPainter& painter) const {
    const double ratio = painter.device()->devicePixelRatioF();
    const QPointF origin = pixelOf(m_camera, ifs::Vector<2>::Zero());
    painter.setPen(QPen(m_style.axis, 1));
    if (origin.x() >= 0 && origin.x() <= m_camera.width)
        painter.drawLine(QPointF(crisp(origin.x(), ratio), 0),
                         QPointF(crisp(origin.x(), ratio), m_camera.height));
    if (origin.y() >= 0 && origin.y() <= m_camera.height)
        painter.drawLine(QPointF(0, crisp(origin.y(), ratio)),
                         QPointF(m_camera.width, crisp(origin.y(), ratio)));
}

// The numbers stand by the axes, or at the edge where an axis is out of sight.
void GridItem::paintLabels(QPainter& painter) const {
    painter.setFont(labelFont(painter));
    painter.setPen(m_style.label);
    const QFontMetricsF metrics(painter.font());
    const GridSpacing spacing = gridSpacing(m_camera.pixelsPerUnit);
    const ifs::Vector<2> corner = worldAt(m_camera, QPointF(0, 0));
    const ifs::Vector<2> opposite = worldAt(m_camera, QPointF(m_camera.width, m_camera.height));
    const QPointF origin = pixelOf(m_camera, ifs::Vector<2>::Zero());
    const Lines across = linesBetween(corner.x(), opposite.x(), spacing.major);
    const double baseline =
        std::clamp(origin.y() + metrics.ascent() + 3, metrics.ascent() + 3,
                   std::max(metrics.ascent() + 3, m_camera.height - metrics.descent() - 3));
    for (double k = across.first; k <= across.last; ++k)
        if (k != 0) {
            const double x = pixelOf(m_camera, {k * spacing.major, 0}).x();
            painter.drawText(QPointF(x + 4, baseline), gridLabel(spacing.major, k));
        }
    const Lines along = linesBetween(corner.y(), opposite.y(), spacing.major);
    for (double k = along.first; k <= along.last; ++k) {
        if (k == 0) continue;
        const QString text = gridLabel(spacing.major, k);
        const double width = metrics.horizontalAdvance(text);
        const double x = std::clamp(origin.x() + 4, 4.0, std::max(4.0, m_camera.width - width - 4));
        painter.drawText(QPointF(x, pixelOf(m_camera, {0, k * spacing.major}).y() - 3), text);
    }
}

void GridItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing, false);
    if (m_grid) paintGrid(*painter);
    if (m_axes) {
        paintAxes(*painter);
        paintLabels(*painter);
    }
    painter->restore();
}

} // namespace view
