// SPDX-License-Identifier: MIT
#pragma once

class QByteArray;
class QMainWindow;

// Restores the panels and bars as QMainWindow::saveState() stored them, also under names of earlier versions.
void restoreStoredLayout(QMainWindow* window, const QByteArray& state);
