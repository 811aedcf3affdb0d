// SPDX-License-Identifier: MIT
#include "space/space_touch.h"

#include "attractor/request/orbit_navigation.h"
#include "canvas/geometry/canvas_geometry.h"

#include <QLineF>

#include <algorithm>
#include <cmath>

namespace view {

namespace {

double distance(const QPointF& a, const QPointF& b) {
    constexpr double minDistance = 10; // pixels; two fingers are never at one point
    return std::max(minDistance, QLineF(a, b).length());
}

// Fingers that zoom turn a little as well: only what goes beyond that turns the view.
double beyondSlack(double twisted) {
    constexpr double slack = 10; // degrees
    return twisted - std::clamp(twisted, -slack, slack);
}

} // namespace

bool SpaceTouch::gesture(const QNativeGestureEvent& event) {
    if (event.gestureType() == Qt::ZoomNativeGesture)
        m_navigation.zoomAt(event.position(), std::max(0.1, 1 + event.value()));
    else if (event.gestureType() == Qt::RotateNativeGesture)
        twist(event);
    else if (event.gestureType() == Qt::SmartZoomNativeGesture)
        m_navigation.fit();
    else {
        m_twisted = 0; // a gesture begins or ends
        return false;
    }
    return true;
}

// What is under the fingers turns with them, as it is seen from above; from below, the other way.
void SpaceTouch::twist(const QNativeGestureEvent& event) {
    const double before = beyondSlack(m_twisted);
    m_twisted += event.value();
    const double turned = beyondSlack(m_twisted) - before;
    if (turned == 0 || m_isFixed) return;
    m_navigation.leaveAxisView();
    const attractor::OrbitCamera& camera = m_navigation.camera();
    const bool isFromBelow = attractor::directionOf(camera, m_navigation.upAxis()).elevation < 0;
    const auto pivot = m_navigation.pointUnder(event.position());
    m_navigation.orbit(camera, pivot.value_or(m_navigation.pivotBeside()), isFromBelow ? -turned : turned, 0);
}

bool SpaceTouch::touch(const QTouchEvent& event) {
    if (event.pointingDevice()->type() != QInputDevice::DeviceType::TouchScreen) return false;
    const QList<QEventPoint>& points = event.points();
    const QEventPoint& first = points.front();
    const auto asMouse = [&](QEvent::Type type) {
        const bool isDown = type != QEvent::MouseButtonRelease;
        return QMouseEvent(type, first.position(), first.scenePosition(), first.globalPosition(),
                           type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
                           isDown ? Qt::LeftButton : Qt::NoButton, event.modifiers());
    };
    if (points.size() >= 2 && !m_pinch) {
        m_input.cancelDrag();
        const QPointF a = points[0].position(), b = points[1].position();
        m_pinch = Pinch{m_navigation.camera(), (a + b) / 2, distance(a, b)};
    } else if (event.type() == QEvent::TouchBegin) {
        m_isHeld = true;
        m_input.press(asMouse(QEvent::MouseButtonPress));
    } else if (event.type() == QEvent::TouchUpdate) {
        if (m_pinch && points.size() >= 2)
            follow(points[0].position(), points[1].position());
        else if (!m_pinch)
            m_input.move(asMouse(QEvent::MouseMove));
    } else {
        const bool isReleased = m_isHeld && !m_pinch && event.type() == QEvent::TouchEnd;
        if (isReleased)
            m_input.release(asMouse(QEvent::MouseButtonRelease));
        else
            m_input.cancelDrag();
        m_pinch.reset();
        m_isHeld = false;
        m_input.leave();
    }
    return true;
}

// What was between the fingers, in the plane of the target, stays there.
void SpaceTouch::follow(const QPointF& a, const QPointF& b) {
    const QPointF middle = (a + b) / 2;
    const attractor::OrbitCamera zoomed = attractor::zoomedAt(
        m_pinch->camera, toVector(m_navigation.inEye(m_pinch->middle)), distance(a, b) / m_pinch->distance);
    m_navigation.moveTo(attractor::panned(zoomed, toVector(middle - m_pinch->middle)), true);
}

} // namespace view
