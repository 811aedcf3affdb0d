// SPDX-License-Identifier: MIT
#include "canvas/geometry/canvas_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace view {

QPointF toPoint(const ifs::Vector<2>& v) {
    return {v.x(), v.y()};
}

ifs::Vector<2> toVector(const QPointF& p) {
    return {p.x(), p.y()};
}

namespace {

// The part on which inside(p) >= 0, inside being linear.
template <class Inside> QPolygonF clippedBy(Inside inside, const QPolygonF& polygon) {
    QPolygonF part;
    for (qsizetype i = 0; i < polygon.size(); ++i) {
        const QPointF &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double atP = inside(p), atQ = inside(q);
        if (atP >= 0) part.append(p);
        if ((atP < 0) != (atQ < 0)) part.append(p + (q - p) * (atP / (atP - atQ)));
    }
    return part;
}

} // namespace

QPolygonF clippedTo(const QRectF& rectangle, QPolygonF polygon) {
    polygon = clippedBy([&](const QPointF& p) { return p.x() - rectangle.left(); }, polygon);
    polygon = clippedBy([&](const QPointF& p) { return rectangle.right() - p.x(); }, polygon);
    polygon = clippedBy([&](const QPointF& p) { return p.y() - rectangle.top(); }, polygon);
    return clippedBy([&](const QPointF& p) { return rectangle.bottom() - p.y(); }, polygon);
}

double distanceToSegment(const QPointF& p, const QPointF& a, const QPointF& b) {
    const QPointF along = b - a;
    const double squared = QPointF::dotProduct(along, along);
    const double t = squared > 0 ? std::clamp(QPointF::dotProduct(p - a, along) / squared, 0.0, 1.0) : 0;
    return QLineF(p, a + t * along).length();
}

QPointF pixelOf(const attractor::Camera& camera, const ifs::Vector<2>& world) {
    return toPoint(attractor::toPixel(camera, world));
}

QPolygonF pixelsOf(const attractor::Camera& camera, const std::vector<ifs::Vector<2>>& points) {
    QPolygonF polygon;
    polygon.reserve(qsizetype(points.size()));
    for (const ifs::Vector<2>& point : points)
        polygon.append(pixelOf(camera, point));
    return polygon;
}

QRectF pixelsOf(const attractor::Camera& camera, const ifs::Vector<2>& min, const ifs::Vector<2>& max) {
    if (camera.rotation == 0) return QRectF(pixelOf(camera, min), pixelOf(camera, max)).normalized();
    return pixelsOf(camera, {min, {max.x(), min.y()}, max, {min.x(), max.y()}}).boundingRect();
}

ifs::Vector<2> worldAt(const attractor::Camera& camera, const QPointF& pixel) {
    return attractor::toWorld(camera, toVector(pixel));
}

ifs::Vector<2> worldOffset(const attractor::Camera& camera, const QPointF& pixels) {
    const double up = camera.yAxis == attractor::YAxis::Up ? -1 : 1;
    ifs::Vector<2> offset = toVector(pixels);
    if (camera.rotation != 0) offset = (attractor::screenTurn(-camera.rotation) * offset).eval();
    return {offset.x() / camera.pixelsPerUnit, up * offset.y() / camera.pixelsPerUnit};
}

namespace {

// The pixelTransform() of cameras that are turned.
QTransform turnedTransform(const attractor::Camera& from, const attractor::Camera& to) {
    const double scale = to.pixelsPerUnit / from.pixelsPerUnit;
    const double down = to.yAxis == attractor::YAxis::Up ? -1 : 1;
    ifs::Matrix<2> linear = attractor::screenTurn(to.rotation - from.rotation);
    if (from.yAxis != to.yAxis) { // a mirror reverses the direction of rotation
        linear = attractor::screenTurn(to.rotation + from.rotation);
        linear.col(1) *= -1;
    }
    linear *= scale;
    const ifs::Vector<2> away = (from.centre - to.centre) * to.pixelsPerUnit;
    const ifs::Vector<2> shift =
        attractor::screenTurn(to.rotation) * ifs::Vector<2>(away.x(), down * away.y()) -
        linear * ifs::Vector<2>(from.width / 2.0, from.height / 2.0);
    return {linear(0, 0),
            linear(1, 0),
            linear(0, 1),
            linear(1, 1),
            shift.x() + to.width / 2.0,
            shift.y() + to.height / 2.0};
}

} // namespace

QTransform pixelTransform(const attractor::Camera& from, const attractor::Camera& to) {
    if (from.rotation != 0 || to.rotation != 0) return turnedTransform(from, to);
    const double scale = to.pixelsPerUnit / from.pixelsPerUnit;
    const double flip = from.yAxis == to.yAxis ? scale : -scale;
    const double down = to.yAxis == attractor::YAxis::Up ? -1 : 1;
    const ifs::Vector<2> shift = (from.centre - to.centre) * to.pixelsPerUnit;
    return QTransform(scale, 0, 0, flip, to.width / 2.0 + shift.x() - scale * from.width / 2.0,
                      to.height / 2.0 + down * shift.y() - flip * from.height / 2.0);
}

attractor::Camera deviceCamera(const attractor::Camera& view, double ratio) {
    attractor::Camera device = view;
    device.width = std::max(1, int(std::lround(view.width * ratio)));
    device.height = std::max(1, int(std::lround(view.height * ratio)));
    device.pixelsPerUnit = view.pixelsPerUnit * ratio;
    // Keeps rounding of the size from shifting the picture by a part of a pixel.
    if (device.width != view.width * ratio || device.height != view.height * ratio)
        device.centre = worldAt(view, QPointF(device.width / (2 * ratio), device.height / (2 * ratio)));
    return device;
}

attractor::Camera withinDepth(attractor::Camera camera) {
    constexpr double minScale = 1e-30;
    constexpr double maxScale = 1e30;
    const double magnitude = camera.centre.cwiseAbs().maxCoeff();
    const double pixel = 64 * std::numeric_limits<double>::epsilon() * magnitude;
    camera.pixelsPerUnit =
        std::clamp(camera.pixelsPerUnit, minScale, std::min(maxScale, 1 / std::max(pixel, 1e-30)));
    return camera;
}

} // namespace view
