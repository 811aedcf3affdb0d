// SPDX-License-Identifier: MIT
#include "gestures/viewport_input.h"

#include "widgets/arrow_keys.h"

#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPointingDevice>
#include <QTouchEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace view {

namespace {

constexpr double notchPixels = 60; // pixels of a touchpad that equal a notch of a wheel
constexpr double notchAngle = 120; // eighths of a degree
constexpr double zoomNotches = 4;  // notches that double the scale

// Fingers that zoom turn a little as well: only a twist beyond that turns the view.
double beyondSlack(double twist) {
    constexpr double slack = 10; // degrees
    return twist - std::clamp(twist, -slack, slack);
}

Qt::KeyboardModifier modifierOf(int key) {
    switch (key) {
    case Qt::Key_Shift:
        return Qt::ShiftModifier;
    case Qt::Key_Control:
        return Qt::ControlModifier;
    case Qt::Key_Alt:
        return Qt::AltModifier;
    default:
        return Qt::NoModifier;
    }
}

} // namespace

void ViewportInput::follow(const QMouseEvent& event) {
    m_pointer = {event.position(), event.modifiers(), Reach::Mouse};
    m_isOver = true;
}

void ViewportInput::press(const QMouseEvent& event) {
    follow(event);
    if (isHolding()) return pressedMore();
    m_button = event.button();
    if (m_button == Qt::MiddleButton || (m_button == Qt::LeftButton && m_isSpaceHeld)) {
        m_navigation.hold();
        m_press = event.position();
        m_held = Held::View;
    } else {
        m_held = Held::Content;
        if (!pressed(m_button)) letGo();
    }
    emit changed();
}

void ViewportInput::handleDoubleClick(const QMouseEvent& event) {
    follow(event);
    const bool isPlain = event.button() == Qt::LeftButton && !m_isSpaceHeld && !isHolding();
    if (!isPlain || !doubleClicked()) press(event);
}

void ViewportInput::move(const QMouseEvent& event) {
    follow(event);
    m_held == Held::View ? m_navigation.moveHeld(m_pointer.position - m_press) : moved();
    emit changed();
}

void ViewportInput::release(const QMouseEvent& event) {
    follow(event);
    if (isHolding() && event.button() != m_button) return;
    const bool isReleased = m_held == Held::Content;
    letGo();
    isReleased ? released() : moved();
    emit changed();
}

void ViewportInput::leave() {
    m_isOver = false;
    left();
    emit pointerLeft();
    emit changed();
}

bool ViewportInput::gesture(const QNativeGestureEvent& event) {
    m_pointer.position = event.position();
    m_isOver = true;
    if (event.gestureType() == Qt::ZoomNativeGesture)
        m_navigation.zoomAt(event.position(), std::max(0.1, 1 + event.value()));
    else if (event.gestureType() == Qt::RotateNativeGesture)
        twist(event);
    else if (event.gestureType() == Qt::SmartZoomNativeGesture)
        m_navigation.fit();
    else {
        m_twisted = 0; // beginning or end of a gesture
        return false;
    }
    return true;
}

void ViewportInput::twist(const QNativeGestureEvent& event) {
    const double before = beyondSlack(m_twisted);
    m_twisted += event.value();
    if (const double turned = beyondSlack(m_twisted) - before; turned != 0)
        m_navigation.twistAt(event.position(), turned);
}

ViewportInput::Fingers ViewportInput::fingersOf(const QTouchEvent& event) {
    constexpr double minDistance = 10; // pixels; two fingers are never at one point
    const QPointF a = event.points()[0].position(), b = event.points()[1].position();
    return {(a + b) / 2, std::max(minDistance, QLineF(a, b).length())};
}

// One finger does what the left button does, two hold the view. A touchpad is left to the mouse it moves.
bool ViewportInput::touch(const QTouchEvent& event) {
    if (event.pointingDevice()->type() != QInputDevice::DeviceType::TouchScreen) return false;
    m_pointer = {event.points().front().position(), event.modifiers(), Reach::Touch};
    m_isOver = true;
    const bool areTwo = event.points().size() >= 2;
    if (areTwo && !m_fingers) {
        cancelDrag();
        m_navigation.hold();
        m_fingers = fingersOf(event);
        return true;
    }
    switch (event.type()) {
    case QEvent::TouchBegin:
        m_held = Held::Content;
        pressed(Qt::LeftButton);
        break;
    case QEvent::TouchUpdate:
        if (!m_fingers) {
            moved();
        } else if (areTwo) {
            const auto [middle, distance] = fingersOf(event);
            m_navigation.moveHeld(middle - m_fingers->middle, m_fingers->middle,
                                  distance / m_fingers->distance);
        }
        break;
    case QEvent::TouchCancel:
        cancelDrag();
        [[fallthrough]];
    default:
        m_fingers.reset();
        letGo();
        released();
        left();
        break;
    }
    emit changed();
    return true;
}

double ViewportInput::notches(const QWheelEvent& event) {
    // Alt and Shift turn the wheel sideways on some platforms, and touchpads drift sideways.
    const bool turnsSideways = event.modifiers() & (Qt::AltModifier | Qt::ShiftModifier);
    const QPoint pixels = event.pixelDelta(), angle = event.angleDelta();
    if (!pixels.isNull()) return (pixels.y() == 0 && turnsSideways ? pixels.x() : pixels.y()) / notchPixels;
    return (angle.y() != 0 ? angle.y() : angle.x()) / notchAngle;
}

void ViewportInput::turnWheel(const QWheelEvent& event) {
    m_pointer.position = event.position(); // the pointer may not have moved since it entered
    m_isOver = true;
    if (m_held != Held::View && !wheelTurned(event))
        m_navigation.zoomAt(event.position(), std::exp2(notches(event) / zoomNotches));
}

void ViewportInput::setModifiers(Qt::KeyboardModifiers modifiers) {
    m_pointer.modifiers = modifiers;
    if (m_held != Held::Content) return;
    moved();
    emit changed();
}

bool ViewportInput::needsKey(const QKeyEvent& event) const {
    return !arrowDirection(event.key()).isNull() || event.key() == Qt::Key_Space;
}

bool ViewportInput::pressKey(const QKeyEvent& event) {
    if (const Qt::KeyboardModifier modifier = modifierOf(event.key()); modifier != Qt::NoModifier) {
        setModifiers(event.modifiers() | modifier);
        return true;
    }
    if (keyPressed(event)) return true;
    if (event.key() != Qt::Key_Space) return false;
    if (!event.isAutoRepeat()) m_isSpaceHeld = true;
    emit changed();
    return true;
}

bool ViewportInput::releaseKey(const QKeyEvent& event) {
    bool isOurs = true;
    if (const Qt::KeyboardModifier modifier = modifierOf(event.key()); modifier != Qt::NoModifier)
        setModifiers(event.modifiers() & ~Qt::KeyboardModifiers(modifier));
    else if (event.key() == Qt::Key_Space && !event.isAutoRepeat())
        m_isSpaceHeld = false;
    else
        isOurs = keyReleased(event);
    emit changed();
    return isOurs;
}

void ViewportInput::setFocused(bool focused) {
    if (!focused) m_isSpaceHeld = false;
    emit changed();
}

bool ViewportInput::cancelGesture() {
    if (m_held != Held::View) return cancelled();
    m_navigation.restoreHeld();
    letGo();
    emit changed();
    return true;
}

void ViewportInput::interrupt() {
    cancelDrag();
    if (m_held == Held::View) cancelGesture();
    letGo();
}

QCursor ViewportInput::cursor() const {
    if (m_held == Held::View) return Qt::ClosedHandCursor;
    if (m_isSpaceHeld && !isHolding()) return Qt::OpenHandCursor;
    return cursorOver();
}

} // namespace view
