// SPDX-License-Identifier: MIT
#pragma once

class QMainWindow;

// Moves the keyboard focus to the next or previous part of the window, round and round: the canvas, the open
// panels from left to right and from top to bottom, the bars. A part that had the focus before gets it back
// where it was.
void walkFocus(QMainWindow& window, int step);
