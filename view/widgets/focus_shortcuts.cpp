// SPDX-License-Identifier: MIT
#include "widgets/focus_shortcuts.h"

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QWidget>

namespace view {

FocusShortcuts::FocusShortcuts(QWidget* widget) : QObject(widget), m_widget(widget) {
    widget->installEventFilter(this);
}

bool FocusShortcuts::eventFilter(QObject*, QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress) return false;
    // Ignores keys left over by an inner editor, such as the Enter that ends it.
    const QWidget* focused = QApplication::focusWidget();
    if (focused != m_widget && m_widget->isAncestorOf(focused)) return false;
    QAction* action = actionFor(event);
    if (!action) return false;
    event->accept();
    if (event->type() == QEvent::KeyPress) action->trigger();
    return true;
}

QAction* FocusShortcuts::actionFor(const QEvent* event) const {
    const QKeySequence keys(static_cast<const QKeyEvent*>(event)->keyCombination());
    for (QAction* action : m_widget->actions())
        if (action->isEnabled() && action->shortcuts().contains(keys)) return action;
    return nullptr;
}

} // namespace view
