// SPDX-License-Identifier: MIT
#pragma once

#include "gestures/pointer.h"
#include "gestures/view_navigation.h"

#include <QCursor>
#include <QObject>

#include <optional>

class QKeyEvent;
class QMouseEvent;
class QNativeGestureEvent;
class QTouchEvent;
class QWheelEvent;

namespace view {

// Input of pointer, wheel, fingers and keys on a canvas, alike in plane and space: the middle button, or the
// left one with the space bar, pans; so do two fingers, which also zoom; the wheel zooms at the pointer. All
// other input goes to the canvas, one gesture at a time.
class ViewportInput : public QObject {
    Q_OBJECT

public:
    explicit ViewportInput(ViewNavigation& navigation) : m_navigation(navigation) {}

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
    virtual bool needsKey(const QKeyEvent& event) const; // so that no shortcut of the window may take it
    void setFocused(bool focused);

    bool isHolding() const { return m_held != Held::Nothing; } // a button or a finger is down
    bool cancelGesture();                                      // false when none was under way
    virtual void cancelDrag() = 0;                             // as above, but of what lies on the canvas
    void interrupt();                                          // the release will not come
    QCursor cursor() const;

signals:
    void changed(); // the cursor, or what is marked under the pointer
    void pointerLeft();
    void message(const QString& sentence); // for the status bar

protected:
    const Pointer& pointer() const { return m_pointer; }
    bool isOver() const { return m_isOver; } // the pointer has not left
    void letGo() { m_held = Held::Nothing; } // although the button is still down
    void forgetPointer() { m_pointer.position = {-1, -1}; }

    virtual bool pressed(Qt::MouseButton button) = 0; // whether it is held from now on
    virtual void pressedMore() {}                     // another button, while one is held
    virtual bool doubleClicked() { return false; }    // by the left button; false: it is a press
    virtual void moved() = 0;                         // whether or not something is held
    virtual void released() = 0;                      // by the button that pressed it
    virtual void left() = 0;
    virtual bool wheelTurned(const QWheelEvent& event) = 0; // false: it zooms
    virtual bool keyPressed(const QKeyEvent& event) = 0;    // whether it meant something
    virtual bool keyReleased(const QKeyEvent&) { return false; }
    virtual bool cancelled() = 0;           // false: there was nothing to cancel
    virtual QCursor cursorOver() const = 0; // while the view itself is not held

    // Notches by which the wheel was turned. A touchpad reports pixels, a wheel eighths of a degree; fine
    // wheels send parts of a notch.
    static double notches(const QWheelEvent& event);

private:
    enum class Held { Nothing, Content, View };
    struct Fingers {
        QPointF middle;
        double distance;
    };
    static Fingers fingersOf(const QTouchEvent& event);
    void follow(const QMouseEvent& event);
    void twist(const QNativeGestureEvent& event);
    void setModifiers(Qt::KeyboardModifiers modifiers);

    ViewNavigation& m_navigation;
    Held m_held = Held::Nothing;
    Qt::MouseButton m_button = Qt::NoButton; // that holds it
    QPointF m_press;                         // of the view
    std::optional<Fingers> m_fingers;        // two, when they came
    Pointer m_pointer;
    bool m_isOver = false;
    bool m_isSpaceHeld = false;
    double m_twisted = 0; // degrees, by the fingers on a touchpad, clockwise
};

} // namespace view
