// SPDX-License-Identifier: MIT
// What arrives at the canvas: pointer, wheel, fingers, keys, and what the window tells it.
#include "canvas/canvas_view.h"

#include "canvas/cage_tool.h"
#include "canvas/canvas_geometry.h"
#include "canvas/canvas_menu.h"
#include "canvas/canvas_scene.h"

#include <QContextMenuEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPointingDevice>
#include <QTouchEvent>
#include <QWheelEvent>
#include <QWindow>

#include <algorithm>
#include <cmath>
#include <utility>

namespace view {

namespace {

constexpr double keyZoom = 1.25;
constexpr double keyPan = 40; // pixels
constexpr int notch = 120;    // of a wheel, in eighths of a degree

double wheelFactor(const QWheelEvent& event) {
    // A touchpad reports pixels, a wheel eighths of a degree: one notch is 120 of them, fine wheels send
    // parts of it.
    if (!event.pixelDelta().isNull()) return std::exp2(event.pixelDelta().y() / 240.0);
    // With Alt held some platforms turn the wheel sideways.
    const int angle = event.angleDelta().y() != 0 ? event.angleDelta().y() : event.angleDelta().x();
    return std::exp2(angle / 480.0);
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

QPointF arrow(int key) {
    switch (key) {
    case Qt::Key_Left:
        return {1, 0};
    case Qt::Key_Right:
        return {-1, 0};
    case Qt::Key_Up:
        return {0, 1};
    case Qt::Key_Down:
        return {0, -1};
    default:
        return {};
    }
}

} // namespace

bool CanvasView::event(QEvent* event) {
    // Keys that mean something here must not be taken by shortcuts of the window: the arrows and Backspace.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = static_cast<QKeyEvent&>(*event);
        if (!arrow(key.key()).isNull() || key.key() == Qt::Key_Space ||
            (key.key() == Qt::Key_Backspace && m_tool == Tool::DefineTriangle)) {
            event->accept();
            return true;
        }
    }
    return QGraphicsView::event(event);
}

bool CanvasView::viewportEvent(QEvent* event) {
    switch (event->type()) {
    case QEvent::Leave:
        active().leave();
        emit pointerLeft();
        break;
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
    case QEvent::TouchCancel:
        return touch(static_cast<QTouchEvent&>(*event)) || QGraphicsView::viewportEvent(event);
    case QEvent::NativeGesture: {
        const auto& gesture = static_cast<QNativeGestureEvent&>(*event);
        if (gesture.gestureType() == Qt::ZoomNativeGesture)
            zoomAt(gesture.position(), std::max(0.1, 1 + gesture.value()));
        else if (gesture.gestureType() == Qt::SmartZoomNativeGesture)
            fit();
        else
            break;
        return true;
    }
    default:
        break;
    }
    return QGraphicsView::viewportEvent(event);
}

// One finger does what the left button does, two hold the plane. A touchpad is left to the mouse it moves.
bool CanvasView::touch(const QTouchEvent& event) {
    if (event.pointingDevice()->type() != QInputDevice::DeviceType::TouchScreen) return false;
    const QList<QEventPoint>& points = event.points();
    m_pointer = {points.front().position(), event.modifiers(), Reach::Touch};
    if (points.size() >= 2 && !m_pinch.isActive()) {
        if (taking()) active().cancel();
        m_pinch.press(camera(), points[0].position(), points[1].position());
        return true;
    }
    switch (event.type()) {
    case QEvent::TouchBegin:
        m_holding = Holding::Tool;
        active().press(m_pointer);
        break;
    case QEvent::TouchUpdate:
        if (!m_pinch.isActive()) {
            active().move(m_pointer);
            report(m_pointer.position);
        } else if (points.size() >= 2) {
            m_fitted = false;
            setCamera(m_pinch.cameraAt(points[0].position(), points[1].position()));
        }
        break;
    case QEvent::TouchCancel:
        if (taking()) active().cancel();
        [[fallthrough]];
    default:
        m_pinch.release();
        m_holding = Holding::Nothing;
        active().release(m_pointer);
        active().leave();
        break;
    }
    return true;
}

void CanvasView::resizeEvent(QResizeEvent*) {
    adoptViewport();
}

void CanvasView::showEvent(QShowEvent* event) {
    QGraphicsView::showEvent(event);
    if (QWindow* handle = window()->windowHandle())
        connect(handle, &QWindow::screenChanged, this, &CanvasView::adoptViewport, Qt::UniqueConnection);
    adoptViewport();
    if (!std::exchange(m_placed, true)) fit();
}

void CanvasView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        m_scene->setDesktop(palette(), font());
    QGraphicsView::changeEvent(event);
}

void CanvasView::wheelEvent(QWheelEvent* event) {
    if (m_tool == Tool::Branch && event->modifiers().testFlag(Qt::ShiftModifier)) {
        m_wheelTurned += event->angleDelta().y() + event->angleDelta().x();
        setBranchDepth(branchDepth() + m_wheelTurned / notch);
        m_wheelTurned %= notch;
        event->accept();
        return;
    }
    zoomAt(event->position(), wheelFactor(*event));
    event->accept();
}

void CanvasView::report(const QPointF& position) {
    PointerPosition pointer{worldAt(camera(), position), std::nullopt};
    if (const auto& cage = m_scene->cage(); cage && cage->current.size() == 3) {
        const ifs::Simplex<2> triangle{cage->current[0], cage->current[1], cage->current[2]};
        if (ifs::isAffineBasis<2>(triangle))
            pointer.barycentric = ifs::barycentric<2>(triangle, pointer.world);
    }
    if (m_holding == Holding::Nothing) findAddress(pointer);
    emit pointerMoved(pointer);
}

void CanvasView::findAddress(PointerPosition& pointer) {
    pointer.address = m_scene->addressAt(pixelOf(camera(), pointer.world));
    pointer.fixedLength = std::min(std::size_t(branchDepth()), pointer.address.size());
    const auto end = pointer.address.begin() + std::ptrdiff_t(pointer.fixedLength);
    pointer.fixedPoint = m_scene->addresses().fixedPoint({pointer.address.begin(), end});
}

void CanvasView::refreshCursor() {
    if (m_holding == Holding::Plane)
        viewport()->setCursor(Qt::ClosedHandCursor);
    else if (m_spaceHeld && m_holding == Holding::Nothing)
        viewport()->setCursor(Qt::OpenHandCursor);
    else
        viewport()->setCursor(active().cursor(m_pointer));
}

void CanvasView::mousePressEvent(QMouseEvent* event) {
    m_pointer = {event->position(), event->modifiers(), Reach::Mouse};
    if (m_holding != Holding::Nothing) return;
    const bool left = event->button() == Qt::LeftButton;
    if (event->button() == Qt::MiddleButton || (left && m_spaceHeld)) {
        m_pan.press(camera(), event->position());
        m_holding = Holding::Plane;
    } else if (left) {
        m_holding = Holding::Tool;
        active().press(m_pointer);
    }
    refreshCursor();
}

void CanvasView::mouseDoubleClickEvent(QMouseEvent* event) {
    const CanvasPart part = m_scene->partAt(event->position(), Reach::Mouse);
    if (event->button() == Qt::LeftButton && !m_spaceHeld && m_tool == Tool::Cage &&
        part.kind == CanvasPart::Kind::Edge)
        insertVertexAt(part.index, event->position());
    mousePressEvent(event);
}

void CanvasView::insertVertexAt(int edge, const QPointF& position) {
    m_cageTool->insertVertexAt(edge, position);
}

void CanvasView::mouseMoveEvent(QMouseEvent* event) {
    m_pointer = {event->position(), event->modifiers(), Reach::Mouse};
    if (m_holding == Holding::Plane) {
        m_fitted = false;
        setCamera(m_pan.cameraAt(event->position()));
    } else {
        active().move(m_pointer);
    }
    report(event->position());
    refreshCursor();
}

void CanvasView::mouseReleaseEvent(QMouseEvent* event) {
    m_pointer = {event->position(), event->modifiers(), Reach::Mouse};
    const bool left = event->button() == Qt::LeftButton;
    if (m_holding == Holding::Plane && (left || event->button() == Qt::MiddleButton)) {
        m_pan.release();
        m_holding = Holding::Nothing;
    } else if (m_holding == Holding::Tool && left) {
        m_holding = Holding::Nothing;
        active().release(m_pointer);
    }
    refreshCursor();
}

void CanvasView::contextMenuEvent(QContextMenuEvent* event) {
    event->accept();
    if (m_holding != Holding::Nothing) return;
    if (m_tool == Tool::DefineTriangle) {
        active().cancel();
        return;
    }
    if (event->reason() == QContextMenuEvent::Keyboard) {
        const CanvasPart part = m_scene->focused();
        const QPointF position = part.kind == CanvasPart::Kind::None ? QPointF(viewport()->rect().center())
                                                                     : m_scene->positionOf(part);
        popUpCanvasMenu({*this, *m_document, *m_scene}, part, viewport()->mapToGlobal(position.toPoint()));
        return;
    }
    const QPointF position = viewport()->mapFromGlobal(event->globalPos());
    popUpCanvasMenu({*this, *m_document, *m_scene}, m_scene->partAt(position, Reach::Mouse),
                    event->globalPos());
}

void CanvasView::updateModifiers(Qt::KeyboardModifiers modifiers) {
    m_pointer.modifiers = modifiers;
    if (m_holding == Holding::Tool) active().move(m_pointer);
}

void CanvasView::keyPressEvent(QKeyEvent* event) {
    if (const Qt::KeyboardModifier modifier = modifierOf(event->key()); modifier != Qt::NoModifier) {
        updateModifiers(event->modifiers() | modifier);
        return;
    }
    if (event->key() == Qt::Key_Space && !event->isAutoRepeat()) {
        m_spaceHeld = true;
        refreshCursor();
        return;
    }
    if (active().keyPress(*event) || canvasKey(*event)) {
        event->accept();
        return;
    }
    event->ignore();
}

// Whether the key means something to the canvas whatever the tool.
bool CanvasView::canvasKey(const QKeyEvent& event) {
    const bool plain = !(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
    if (const QPointF way = arrow(event.key()); !way.isNull()) {
        pan(way * (event.modifiers().testFlag(Qt::ShiftModifier) ? 5 * keyPan : keyPan));
        return true;
    }
    if (event.key() == Qt::Key_Escape) {
        if (cancelGesture()) return true;
        const bool focused = m_scene->focused().kind != CanvasPart::Kind::None;
        m_scene->setFocused({});
        return focused;
    }
    if (!plain) return false;
    switch (event.key()) {
    case Qt::Key_Space:
        return true;
    case Qt::Key_F:
        fit();
        return true;
    case Qt::Key_1:
        resetZoom();
        return true;
    case Qt::Key_H:
        setOverlaysVisible(!overlaysVisible());
        return true;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        zoomBy(keyZoom);
        return true;
    case Qt::Key_Minus:
        zoomBy(1 / keyZoom);
        return true;
    case Qt::Key_F6:
        return QGraphicsView::focusNextPrevChild(!event.modifiers().testFlag(Qt::ShiftModifier));
    default:
        return false;
    }
}

void CanvasView::focusOn(const CanvasPart& part) {
    setFocus(Qt::TabFocusReason);
    m_scene->setFocused(part);
}

void CanvasView::keyReleaseEvent(QKeyEvent* event) {
    if (const Qt::KeyboardModifier modifier = modifierOf(event->key()); modifier != Qt::NoModifier)
        updateModifiers(event->modifiers() & ~Qt::KeyboardModifiers(modifier));
    else if (event->key() == Qt::Key_Space && !event->isAutoRepeat())
        m_spaceHeld = false;
    else if (!active().keyRelease(*event))
        event->ignore();
    refreshCursor();
}

void CanvasView::focusOutEvent(QFocusEvent* event) {
    m_spaceHeld = false;
    refreshCursor();
    QGraphicsView::focusOutEvent(event);
}

bool CanvasView::focusNextPrevChild(bool next) {
    if (!taking() || !m_scene->cage() || !overlaysVisible()) return QGraphicsView::focusNextPrevChild(next);
    taking()->walk(next ? 1 : -1);
    return true;
}

void CanvasView::describeFocus() {
    // While a part is dragged the read-out of the pointer says where it is.
    const CanvasPart part = m_scene->focused();
    if (part.kind != CanvasPart::Kind::None && m_holding == Holding::Nothing)
        emit message(tr("%1: %2").arg(m_scene->nameOf(part), m_scene->placeOf(part)));
}

} // namespace view
