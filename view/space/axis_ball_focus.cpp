// SPDX-License-Identifier: MIT
#include "space/axis_ball_focus.h"

#include "widgets/arrow_keys.h"

namespace view {

namespace {

bool isPlain(const QKeyEvent& event) {
    return (event.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
}

bool looksAlong(const QKeyEvent& event) {
    return event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter || event.key() == Qt::Key_Space;
}

} // namespace

std::optional<AxisBall::End> AxisBallFocus::end() const {
    return canTake() ? m_end : std::nullopt;
}

bool AxisBallFocus::needsKey(const QKeyEvent& event) const {
    return isHere() && isPlain(event) && (looksAlong(event) || event.key() == Qt::Key_Escape);
}

bool AxisBallFocus::keyPress(const QKeyEvent& event) {
    if (!isHere() || !isPlain(event)) return false;
    if (const QPointF way = arrowDirection(event.key()); !way.isNull()) {
        m_end = m_ball.beside(*m_end, way).value_or(*m_end);
    } else if (event.key() == Qt::Key_Escape) {
        leave();
    } else if (looksAlong(event)) {
        // The other end is in front in a view from behind. A held key has an effect only once.
        if (!event.isAutoRepeat()) m_end = m_navigation.lookAlong(*m_end);
    } else {
        return false;
    }
    return true;
}

} // namespace view
