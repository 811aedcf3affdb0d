// SPDX-License-Identifier: MIT
#pragma once

#include <QKeySequence>
#include <QList>

#include <optional>

class QAction;
class QString;

// The keys of commands, as their users want them. A command is an action with an object name, under which its
// keys are stored as "shortcuts/<name>"; every window has one of that name. To be called in the thread of the
// windows.
namespace view {

using Shortcuts = QList<QKeySequence>;

// Takes the keys that the action has for its usual ones, and gives it the user's instead, if there are some.
void adoptShortcuts(QAction& action);

Shortcuts usualShortcuts(const QAction& action);

// Stores the keys of a command, or nullopt to return to its usual ones, and gives them to it in all windows.
void setShortcuts(const QString& command, const std::optional<Shortcuts>& keys);

// What to press for a command, for a sentence: the first of its keys, else its name in quotes. `usual` are
// the keys where no window has the command.
QString toPress(const QString& command, const QKeySequence& usual);

// Why a command cannot have these keys, which the canvas and the fields use themselves; else empty.
QString shortcutObstacle(const QKeySequence& keys);

} // namespace view
