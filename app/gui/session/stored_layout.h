// SPDX-License-Identifier: MIT
#pragma once

class QByteArray;
class QMainWindow;

// Restores the panels and bars as QMainWindow::saveState() stored them, also under names of earlier versions;
// false: nothing is stored, or not by this program.
bool restoreStoredLayout(QMainWindow* window, const QByteArray& state);
