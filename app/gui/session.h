// SPDX-License-Identifier: MIT
#pragma once

#include <QList>
#include <QStringList>

class MainWindow;

// The windows of this run, and the files they showed when it ended.
namespace session {

QList<MainWindow*> windows();
QStringList files(); // of the last run, those that still exist

// While the last window closes: its file is what the next run begins with.
void remember();
// Closes all windows, each asking first; when none stayed, their files are what the next run begins with.
void quit();

} // namespace session
