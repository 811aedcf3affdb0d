// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/canvas_navigation.h"
#include "canvas/pointer_position.h"
#include "canvas/tools/pan_gesture.h"
#include "canvas/tools/pinch_gesture.h"
#include "canvas/tools/toolbox.h"

class QContextMenuEvent;
class QKeyEvent;
class QMouseEvent;
class QNativeGestureEvent;
class QTouchEvent;
class QWheelEvent;

namespace view {

// What pointer, wheel, fingers and keys do on the canvas: they work the tool in use, or move the plane.
class CanvasInput : public QObject {
    Q_OBJECT

public:
    CanvasInput(CanvasScene& scene, Toolbox& tools, CanvasNavigation& navigation, CanvasOptions& options)
        : m_scene(scene), m_tools(tools), m_navigation(navigation), m_options(options) {}

    void press(const QMouseEvent& event);
    void handleDoubleClick(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    void leave();
    void turnWheel(const QWheelEvent& event);
    bool gesture(const QNativeGestureEvent& event); // whether it meant something, as the three below
    bool touch(const QTouchEvent& event);
    bool pressKey(const QKeyEvent& event);
    bool releaseKey(const QKeyEvent& event);
    bool needsKey(const QKeyEvent& event) const; // so that no shortcut of the window may take it
    void loseFocus();

    bool isHolding() const { return m_holding != Holding::Nothing; } // a button is down
    bool cancelGesture();                                            // false when none was under way
    QCursor cursor() const;
    void reportPointer() { reportAt(m_pointer.position); } // as pointerMoved()
    void reportAgain(); // where it was last reported: more is known of it, or the plane has moved under it

signals:
    void pointerMoved(const view::PointerPosition& position);
    void pointerLeft();
    void cursorChanged();
    void message(const QString& sentence); // for the status bar

private:
    enum class Holding { Nothing, Tool, Plane };

    bool canvasKey(const QKeyEvent& event);
    void reportAt(const QPointF& position);
    void beginClick();
    void followClick();
    void endClick();
    void twist(const QNativeGestureEvent& event);
    void updateModifiers(Qt::KeyboardModifiers modifiers);

    CanvasScene& m_scene;
    Toolbox& m_tools;
    CanvasNavigation& m_navigation;
    CanvasOptions& m_options;
    Holding m_holding = Holding::Nothing;
    PanGesture m_pan;
    PinchGesture m_pinch;
    Pointer m_pointer;
    std::optional<QPointF> m_clicked;  // where a press has not become a drag
    std::optional<QPointF> m_reported; // nullopt when the pointer has left
    bool m_spaceHeld = false;
    double m_twisted = 0; // degrees, by the fingers on a touchpad, clockwise
};

} // namespace view
