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
    bool gesture(const QNativeGestureEvent& event); // true if it had an effect, as for the next three
    bool touch(const QTouchEvent& event);
    bool pressKey(const QKeyEvent& event);
    bool releaseKey(const QKeyEvent& event);
    // True for keys that must not become shortcuts of the window.
    virtual bool needsKey(const QKeyEvent& event) const;
    void setFocused(bool focused);

    bool isHolding() const { return m_held != Held::Nothing; } // true while a button or a finger is down
    bool cancelGesture();                                      // false if there was none
    virtual void cancelDrag() = 0;                             // cancels a drag of something on the canvas
    void interrupt(); // for gestures whose release will not be delivered
    QCursor cursor() const;

signals:
    void changed(); // sent for the cursor and for marks under the pointer
    void pointerLeft();
    void message(const QString& sentence); // sentence for the status bar

protected:
    const Pointer& pointer() const { return m_pointer; }
    bool isOver() const { return m_isOver; } // true while the pointer is inside
    void letGo() { m_held = Held::Nothing; } // ends the hold, although the button is still down
    void forgetPointer() { m_pointer.position = {-1, -1}; }

    virtual bool pressed(Qt::MouseButton button) = 0; // true if the press holds the view or something on it
    virtual void pressedMore() {}                     // called for another button during a hold
    virtual bool doubleClicked() { return false; }    // left button; false: treated as a press
    virtual void moved() = 0;                         // called with and without a hold
    virtual void released() = 0;                      // called for the button of the press
    virtual void left() = 0;
    virtual bool wheelTurned(const QWheelEvent& event) = 0; // false: the wheel zooms
    virtual bool keyPressed(const QKeyEvent& event) = 0;    // true if it had an effect
    virtual bool keyReleased(const QKeyEvent&) { return false; }
    virtual bool cancelled() = 0;           // false if there was nothing to cancel
    virtual QCursor cursorOver() const = 0; // cursor unless the view itself is held

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
    Qt::MouseButton m_button = Qt::NoButton; // button of the hold
    QPointF m_press;                         // press in pixels of the view
    std::optional<Fingers> m_fingers;        // set while two fingers are down
    Pointer m_pointer;
    bool m_isOver = false;
    bool m_isSpaceHeld = false;
    double m_twisted = 0; // degrees clockwise, turned by fingers on a touchpad
};

} // namespace view
