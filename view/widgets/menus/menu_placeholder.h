// SPDX-License-Identifier: MIT
#pragma once

#include <QAction>
#include <QMenu>

// A line of a menu that says why nothing is listed there: no command, and not found by a search for one.
namespace view {

constexpr char placeholderProperty[] = "isPlaceholder";

inline QAction* addPlaceholder(QMenu& menu, const QString& text) {
    QAction* action = menu.addAction(text);
    action->setEnabled(false);
    action->setProperty(placeholderProperty, true);
    return action;
}

inline bool isPlaceholder(const QAction& action) {
    return action.property(placeholderProperty).toBool();
}

} // namespace view
