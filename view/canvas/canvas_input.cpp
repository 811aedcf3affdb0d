// SPDX-License-Identifier: MIT
#include "canvas/canvas_input.h"

#include "document/branches/addresses.h"
#include "widgets/arrow_keys.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPointingDevice>
#include <QTouchEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace view {

namespace {

constexpr double keyZoom = 1.25;
constexpr double keyPan = 40;     // pixels
constexpr int notch = 120;        // of a wheel, in eighths of a degree
constexpr double notchTurn = 5;   // degrees
constexpr double clickSlack = 2;  // pixels, as of a drag of a tool
constexpr double twistSlack = 10; // degrees that fingers turn without meaning to
constexpr Qt::KeyboardModifiers turning = Qt::ControlModifier | Qt::ShiftModifier;

// With Alt or Shift held some platforms turn the wheel sideways.
int wheelAngle(const QWheelEvent& event) {
    return event.angleDelta().y() != 0 ? event.angleDelta().y() : event.angleDelta().x();
}

double wheelFactor(const QWheelEvent& event) {
    // A touchpad reports pixels, a wheel eighths of a degree: one notch is 120 of them, fine wheels send
    // parts of it.
    if (!event.pixelDelta().isNull()) return std::exp2(event.pixelDelta().y() / 240.0);
    return std::exp2(wheelAngle(event) / 480.0);
}

double beyondSlack(double twist) {
    return std::copysign(std::max(0.0, std::abs(twist) - twistSlack), twist);
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

bool CanvasInput::needsKey(const QKeyEvent& event) const {
    return !arrowDirection(event.key()).isNull() || event.key() == Qt::Key_Space ||
           (event.key() == Qt::Key_Backspace && m_tools.tool() == Toolbox::Tool::DefineTriangle);
}

bool CanvasInput::gesture(const QNativeGestureEvent& event) {
    m_reported = event.position();
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

// Fingers that zoom turn a little as well: only what goes beyond that turns the view.
void CanvasInput::twist(const QNativeGestureEvent& event) {
    const double before = beyondSlack(m_twisted);
    m_twisted += event.value();
    if (const double turned = beyondSlack(m_twisted) - before; turned != 0)
        m_navigation.rotateAt(event.position(), -turned);
}

// One finger does what the left button does, two hold the plane. A touchpad is left to the mouse it moves.
bool CanvasInput::touch(const QTouchEvent& event) {
    if (event.pointingDevice()->type() != QInputDevice::DeviceType::TouchScreen) return false;
    const QList<QEventPoint>& points = event.points();
    m_pointer = {points.front().position(), event.modifiers(), Reach::Touch};
    if (points.size() >= 2 && !m_pinch.isActive()) {
        if (m_tools.polygonTool()) m_tools.active().cancel();
        m_clicked.reset();
        m_pinch.press(m_navigation.camera(), points[0].position(), points[1].position());
        return true;
    }
    switch (event.type()) {
    case QEvent::TouchBegin:
        m_holding = Holding::Tool;
        beginClick();
        m_tools.toolAt(m_pointer).press(m_pointer);
        break;
    case QEvent::TouchUpdate:
        if (!m_pinch.isActive()) {
            followClick();
            m_tools.active().move(m_pointer);
            reportPointer();
        } else if (points.size() >= 2) {
            m_navigation.moveTo(m_pinch.cameraAt(points[0].position(), points[1].position()));
        }
        break;
    case QEvent::TouchCancel:
        m_clicked.reset();
        if (m_tools.polygonTool()) m_tools.active().cancel();
        [[fallthrough]];
    default:
        m_pinch.release();
        m_holding = Holding::Nothing;
        m_tools.active().release(m_pointer);
        endClick();
        m_tools.active().leave();
        break;
    }
    return true;
}

void CanvasInput::turnWheel(const QWheelEvent& event) {
    m_reported = event.position(); // perhaps it has not moved since it came
    if ((event.modifiers() & turning) == turning) {
        m_navigation.rotateAt(event.position(), notchTurn * wheelAngle(event) / notch);
        return;
    }
    if (m_tools.tool() == Toolbox::Tool::Branch && event.modifiers().testFlag(Qt::ShiftModifier)) {
        m_tools.branchTool().choice().turnDepth(event.angleDelta().y() + event.angleDelta().x());
        return;
    }
    m_navigation.zoomAt(event.position(), wheelFactor(event));
}

void CanvasInput::reportAt(const QPointF& position) {
    m_reported = position;
    PointerPosition pointer = pointerPosition(m_scene, position);
    if (!isHolding()) findAddress(pointer, m_scene, m_tools.branchTool().choice().depth());
    emit pointerMoved(pointer);
}

void CanvasInput::reportAgain() {
    if (m_reported && !isHolding()) reportAt(*m_reported);
}

QCursor CanvasInput::cursor() const {
    if (m_holding == Holding::Plane) return Qt::ClosedHandCursor;
    if (m_spaceHeld && !isHolding()) return Qt::OpenHandCursor;
    return m_tools.toolAt(m_pointer).cursor(m_pointer);
}

void CanvasInput::press(const QMouseEvent& event) {
    m_pointer = {event.position(), event.modifiers(), Reach::Mouse};
    if (isHolding()) return;
    const bool left = event.button() == Qt::LeftButton;
    if (event.button() == Qt::MiddleButton || (left && m_spaceHeld)) {
        m_pan.press(m_navigation.camera(), event.position());
        m_holding = Holding::Plane;
    } else if (left) {
        m_holding = Holding::Tool;
        beginClick();
        m_tools.toolAt(m_pointer).press(m_pointer);
    }
    emit cursorChanged();
}

void CanvasInput::beginClick() {
    const bool takesPolygons = m_tools.tool() == Toolbox::Tool::Cage || m_tools.tool() == Toolbox::Tool::Maps;
    const CanvasPart::Kind kind = m_scene.partAt(m_pointer.position, m_pointer.reach).kind;
    const bool isHandle = kind != CanvasPart::Kind::None && kind != CanvasPart::Kind::Inside;
    m_clicked.reset();
    if (takesPolygons && !isHandle && m_scene.overlaysVisible()) m_clicked = m_pointer.position;
}

void CanvasInput::followClick() {
    if (m_clicked && (m_pointer.position - *m_clicked).manhattanLength() > clickSlack) m_clicked.reset();
}

// A click that is no drag chooses the cylinder there, if an analysis outlines them.
void CanvasInput::endClick() {
    if (!m_clicked || !m_scene.marks().chooseCylinderAt(*std::exchange(m_clicked, {}))) return;
    const auto walk = m_scene.marks().cylinderWalk();
    emit message(walk.empty()
                     ? QString()
                     : tr("Cylinder %1").arg(document::addressText(walk.back()->listed, walk.size())));
}

void CanvasInput::handleDoubleClick(const QMouseEvent& event) {
    const CanvasPart part = m_scene.partAt(event.position(), Reach::Mouse);
    if (event.button() == Qt::LeftButton && !m_spaceHeld && m_tools.tool() == Toolbox::Tool::Cage &&
        part.kind == CanvasPart::Kind::Edge)
        m_tools.cageTool().insertVertexAt(part.index, event.position());
    press(event);
}

void CanvasInput::move(const QMouseEvent& event) {
    m_pointer = {event.position(), event.modifiers(), Reach::Mouse};
    followClick();
    if (m_holding == Holding::Plane)
        m_navigation.moveTo(m_pan.cameraAt(event.position()));
    else
        m_tools.active().move(m_pointer);
    reportPointer();
    emit cursorChanged();
}

void CanvasInput::release(const QMouseEvent& event) {
    m_pointer = {event.position(), event.modifiers(), Reach::Mouse};
    const bool left = event.button() == Qt::LeftButton;
    if (m_holding == Holding::Plane && (left || event.button() == Qt::MiddleButton)) {
        m_pan.release();
        m_holding = Holding::Nothing;
    } else if (m_holding == Holding::Tool && left) {
        m_holding = Holding::Nothing;
        m_tools.active().release(m_pointer);
        endClick();
    }
    emit cursorChanged();
}

void CanvasInput::leave() {
    m_tools.active().leave();
    m_reported.reset();
    emit pointerLeft();
}

bool CanvasInput::cancelGesture() {
    if (m_holding == Holding::Plane) {
        m_navigation.setCamera(m_pan.before());
        m_pan.release();
        m_holding = Holding::Nothing;
        emit cursorChanged();
        return true;
    }
    if (!m_tools.active().isBusy() && m_tools.polygonTool()) return false;
    return m_tools.active().cancel();
}

void CanvasInput::updateModifiers(Qt::KeyboardModifiers modifiers) {
    m_pointer.modifiers = modifiers;
    if (m_holding == Holding::Tool) m_tools.active().move(m_pointer);
}

bool CanvasInput::pressKey(const QKeyEvent& event) {
    if (const Qt::KeyboardModifier modifier = modifierOf(event.key()); modifier != Qt::NoModifier) {
        updateModifiers(event.modifiers() | modifier);
        return true;
    }
    if (event.key() == Qt::Key_Space && !event.isAutoRepeat()) {
        m_spaceHeld = true;
        emit cursorChanged();
        return true;
    }
    return m_tools.active().keyPress(event) || canvasKey(event);
}

// Whether the key means something to the canvas whatever the tool.
bool CanvasInput::canvasKey(const QKeyEvent& event) {
    if (const QPointF way = -arrowDirection(event.key()); !way.isNull()) {
        m_navigation.pan(way * (event.modifiers().testFlag(Qt::ShiftModifier) ? 5 * keyPan : keyPan));
        return true;
    }
    if (event.key() == Qt::Key_Escape) {
        if (cancelGesture()) return true;
        const bool focused = m_scene.selection().focused().kind != CanvasPart::Kind::None;
        m_scene.selection().setFocused({});
        return focused;
    }
    if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) return false;
    switch (event.key()) {
    case Qt::Key_Space:
        return true;
    case Qt::Key_F:
        m_navigation.fit();
        return true;
    case Qt::Key_1:
        m_navigation.resetZoom();
        return true;
    case Qt::Key_H:
        m_options.setOverlaysVisible(!m_options.overlaysVisible());
        return true;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        m_navigation.zoomBy(keyZoom);
        return true;
    case Qt::Key_Minus:
        m_navigation.zoomBy(1 / keyZoom);
        return true;
    default:
        return false;
    }
}

bool CanvasInput::releaseKey(const QKeyEvent& event) {
    bool isOurs = true;
    if (const Qt::KeyboardModifier modifier = modifierOf(event.key()); modifier != Qt::NoModifier)
        updateModifiers(event.modifiers() & ~Qt::KeyboardModifiers(modifier));
    else if (event.key() == Qt::Key_Space && !event.isAutoRepeat())
        m_spaceHeld = false;
    else
        isOurs = m_tools.active().keyRelease(event);
    emit cursorChanged();
    return isOurs;
}

void CanvasInput::loseFocus() {
    m_spaceHeld = false;
    emit cursorChanged();
}

} // namespace view
