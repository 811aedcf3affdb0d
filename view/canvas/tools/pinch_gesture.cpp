// SPDX-License-Identifier: MIT
#include "canvas/tools/pinch_gesture.h"

#include <QLineF>

#include <algorithm>

namespace view {

namespace {

double distance(const QPointF& a, const QPointF& b) {
    constexpr double minDistance = 10; // pixels; two fingers are never at one point
    return std::max(minDistance, QLineF(a, b).length());
}

} // namespace

void PinchGesture::press(const attractor::Camera& camera, const QPointF& a, const QPointF& b) {
    m_start = {camera, (a + b) / 2, distance(a, b)};
}

attractor::Camera PinchGesture::cameraAt(const QPointF& a, const QPointF& b) const {
    const QPointF shift = (a + b) / 2 - m_start->middle;
    const attractor::Camera zoomed = attractor::zoomedAt(
        m_start->camera, {m_start->middle.x(), m_start->middle.y()}, distance(a, b) / m_start->distance);
    return attractor::panned(zoomed, {shift.x(), shift.y()});
}

} // namespace view
