// SPDX-License-Identifier: MIT
#include "space/keypad_views.h"

namespace view {

bool isOnKeypad(const QKeyEvent& event) {
    return event.modifiers().testFlag(Qt::KeypadModifier);
}

bool lookBy(SpaceNavigation& navigation, const QKeyEvent& event) {
    const bool isOpposite = event.modifiers().testFlag(Qt::ControlModifier);
    if (event.key() == Qt::Key_Home) {
        navigation.lookFrom(directions::isometric);
        return true;
    }
    if (!isOnKeypad(event)) return false;
    switch (event.key()) {
    case Qt::Key_1:
        navigation.lookFrom(isOpposite ? directions::back : directions::front);
        return true;
    case Qt::Key_3:
        navigation.lookFrom(isOpposite ? directions::left : directions::right);
        return true;
    case Qt::Key_7:
        navigation.lookFrom(isOpposite ? directions::bottom : directions::top);
        return true;
    case Qt::Key_5:
        navigation.setPerspective(!navigation.isPerspective());
        return true;
    default:
        return false;
    }
}

} // namespace view
