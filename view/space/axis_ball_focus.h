// SPDX-License-Identifier: MIT
#pragma once

#include "space/space_navigation.h"

#include <QKeyEvent>

#include <optional>

namespace view {

// The keyboard on the ball of axes: arrow keys choose one of its ends, Enter and Space look along its axis,
// and Esc goes back to the canvas.
class AxisBallFocus {
public:
    AxisBallFocus(const AxisBall& ball, SpaceNavigation& navigation)
        : m_ball(ball), m_navigation(navigation) {}

    bool canTake() const { return m_ball.isVisible(); }
    void take() { m_end = m_ball.front(); }
    void leave() { m_end.reset(); }
    bool isHere() const { return end().has_value(); }
    std::optional<AxisBall::End> end() const; // chosen end; nullopt while the keyboard focus is elsewhere

    bool needsKey(const QKeyEvent& event) const; // true for keys that must not become shortcuts of the window
    bool keyPress(const QKeyEvent& event);       // false if the key has no effect here

private:
    const AxisBall& m_ball;
    SpaceNavigation& m_navigation;
    std::optional<AxisBall::End> m_end;
};

} // namespace view
