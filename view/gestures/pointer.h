// SPDX-License-Identifier: MIT
#pragma once

#include <QPointF>
#include <Qt>

#include <optional>

namespace view {

enum class Reach { Mouse, Touch }; // size of the target of a press

// The pointer from the point of view of the objects under it.
struct Pointer {
    QPointF position; // pixels of the view
    Qt::KeyboardModifiers modifiers;
    Reach reach = Reach::Mouse;
};

// Effect of a drag.
enum class DragMode { Move, Rotate, Scale };

inline DragMode dragMode(Qt::KeyboardModifiers modifiers) {
    if (modifiers.testFlag(Qt::ControlModifier)) return DragMode::Rotate;
    return modifiers.testFlag(Qt::AltModifier) ? DragMode::Scale : DragMode::Move;
}

} // namespace view
