// SPDX-License-Identifier: MIT
#pragma once

class QMainWindow;

// What's This of every panel, found by its object name, and of the command that shows it.
void explainPanels(const QMainWindow& window);
