// SPDX-License-Identifier: MIT
#pragma once

#include "bridges/export_queue.h"
#include "session/session.h"

#include <QMainWindow>
#include <QString>

class QDockWidget;
class WindowMessages;

// The queue of exports of this program, in its windows.
namespace exports {

QString folder(); // folder where waiting exports are stored

// The queue of all windows, owned by the application and created on demand.
view::ExportQueue* queue();

// The panel of a window, hidden at first: it appears with what earlier runs have left.
void connectPanel(QDockWidget* panel, WindowMessages* messages);

// A window closes, and the program with it or with the last one: whether it may, which the user is asked
// while an animation is exported from this window or exports are not done.
bool mayEnd(QWidget* window, SessionWindow::Leaving leaving);

} // namespace exports
