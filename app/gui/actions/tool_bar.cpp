// SPDX-License-Identifier: MIT
#include "actions/tool_bar.h"

#include <QToolButton>

#include <algorithm>
#include <utility>

ToolBar::ToolBar(const QString& title, const QList<QList<QAction*>>& groups, QMainWindow* window)
    : QToolBar(title, window) {
    setObjectName(QStringLiteral("tools"));
    setMovable(false);
    setIconSize({22, 22});
    for (const QList<QAction*>& group : groups) {
        if (!m_usual.isEmpty()) m_usual << view::separatorId();
        for (const QAction* action : group)
            m_usual << action->objectName();
    }
    adopt(view::Preferences::stored());
}

void ToolBar::adopt(const view::Preferences& preferences) {
    setToolButtonStyle(preferences.labels ? Qt::ToolButtonTextUnderIcon : Qt::ToolButtonIconOnly);
    arrange(preferences.tools.isEmpty() ? m_usual : preferences.tools);
}

// Skips ids that no command has: another version may have stored them.
void ToolBar::arrange(const QStringList& ids) {
    if (std::exchange(m_shown, ids) == ids) return;
    clear();
    const QList<QAction*> commands = parentWidget()->actions();
    for (const QString& id : ids) {
        if (id == view::separatorId()) {
            addSeparator();
            continue;
        }
        const auto found =
            std::ranges::find(commands, id, [](const QAction* action) { return action->objectName(); });
        if (found != commands.end()) addAction(*found);
    }
    for (auto* button : findChildren<QToolButton*>())
        button->setFocusPolicy(Qt::TabFocus);
}
