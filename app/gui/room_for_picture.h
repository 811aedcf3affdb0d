// SPDX-License-Identifier: MIT
#pragma once

class QMainWindow;
class QWidget;

// The panels beside the picture yield until half of the window is left to it. In a window of at most 800 by
// 600 pixels, where the smallest panels take more, those on the left are hidden.
void makeRoomForPicture(QMainWindow& window, const QWidget& picture);

// Shows what was hidden for the picture. Does nothing while the window is as small.
void giveRoomBack(QMainWindow& window);

// The same however small the window is, before its layout is stored.
void showHiddenPanels(QMainWindow& window);
