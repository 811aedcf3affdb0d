// SPDX-License-Identifier: MIT
#pragma once

#include <QFuture>
#include <QString>

class QWidget;

namespace view {

// Handles the events of all windows until the work is finished; when that takes longer than a moment, under a
// dialog over `window` (nullptr: over nothing) that says what is done and how far it is. False as soon as the
// user cancels, somebody cancels the future or the window goes: the work has been told, and goes on until it
// notices.
bool waitFor(QFuture<void> work, const QString& label, QWidget* window);

} // namespace view
