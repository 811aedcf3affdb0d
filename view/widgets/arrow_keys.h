// SPDX-License-Identifier: MIT
#pragma once

#include <QPointF>
#include <Qt>

namespace view {

// A step of one pixel in the direction of an arrow key, y down; null for other keys.
inline QPointF arrowDirection(int key) {
    switch (key) {
    case Qt::Key_Left:
        return {-1, 0};
    case Qt::Key_Right:
        return {1, 0};
    case Qt::Key_Up:
        return {0, -1};
    case Qt::Key_Down:
        return {0, 1};
    default:
        return {};
    }
}

// Pixels, degrees or percent for one press of an arrow key.
inline double nudgePace(Qt::KeyboardModifiers modifiers) {
    if (modifiers.testFlag(Qt::ShiftModifier)) return 10;
    return modifiers.testFlag(Qt::AltModifier) ? 0.1 : 1;
}

} // namespace view
