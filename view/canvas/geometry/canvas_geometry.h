// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"

#include <QPointF>
#include <QPolygonF>
#include <QRectF>
#include <QTransform>

#include <vector>

// Conversions between the plane and the pixels of the canvas. Pixels are device independent unless said
// otherwise.
namespace view {

QPointF toPoint(const ifs::Vector<2>& v);
ifs::Vector<2> toVector(const QPointF& p);

// The part of the polygon that lies in the rectangle, for a fill: where it leaves, its outline follows the
// sides.
QPolygonF clippedTo(const QRectF& rectangle, QPolygonF polygon);

double distanceToSegment(const QPointF& p, const QPointF& a, const QPointF& b);

QPointF pixelOf(const attractor::Camera& camera, const ifs::Vector<2>& world);
QPolygonF pixelsOf(const attractor::Camera& camera, const std::vector<ifs::Vector<2>>& points);
// The pixels around the box, which may be turned.
QRectF pixelsOf(const attractor::Camera& camera, const ifs::Vector<2>& min, const ifs::Vector<2>& max);
ifs::Vector<2> worldAt(const attractor::Camera& camera, const QPointF& pixel);
// The motion in the plane for a motion by `pixels`; exactly zero for no motion.
ifs::Vector<2> worldOffset(const attractor::Camera& camera, const QPointF& pixels);

// The pixels of one camera as pixels of another: where a picture made for `from` belongs in the view `to`.
// Formed from differences, so that it keeps its digits however deep both look.
QTransform pixelTransform(const attractor::Camera& from, const attractor::Camera& to);

// The camera of a picture with `ratio` device pixels to one pixel of the view: the same top left corner.
attractor::Camera deviceCamera(const attractor::Camera& view, double ratio);

// `camera` with its scale kept where a pixel is still many times the spacing of the numbers around it.
attractor::Camera withinDepth(attractor::Camera camera);

} // namespace view
