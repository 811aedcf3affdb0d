// SPDX-License-Identifier: MIT
#pragma once

#include "space/space_input.h"

#include <QNativeGestureEvent>
#include <QTouchEvent>

#include <optional>

namespace view {

// Fingers in the window into space. One does what the left button does; two pan and zoom. On a touchpad a
// pinch zooms at the pointer, and fingers that twist turn the view about the vertical axis.
class SpaceTouch {
public:
    SpaceTouch(SpaceInput& input, SpaceNavigation& navigation) : m_input(input), m_navigation(navigation) {}

    void fixDirection() { m_isFixed = true; }       // nothing turns the view
    bool gesture(const QNativeGestureEvent& event); // false when it means nothing here
    bool touch(const QTouchEvent& event);           // false: left to the mouse

private:
    struct Pinch {
        attractor::OrbitCamera camera;
        QPointF middle;
        double distance = 1;
    };
    void twist(const QNativeGestureEvent& event);
    void follow(const QPointF& a, const QPointF& b);

    SpaceInput& m_input;
    SpaceNavigation& m_navigation;
    std::optional<Pinch> m_pinch;
    bool m_isHeld = false; // one finger is down
    double m_twisted = 0;  // degrees, since the gesture began
    bool m_isFixed = false;
};

} // namespace view
