// SPDX-License-Identifier: MIT
#pragma once

#include <QList>
#include <QRect>

class QByteArray;
class QMainWindow;

// Places for new windows. All rectangles are without the frame.

// `wanted`, moved into the room as far as it is not larger; where another window begins there, so far to the
// right and below that the title bar of that one can be seen. When there is no such place for its size, it
// becomes smaller, but not below `least`.
QRect placeBeside(const QRect& wanted, const QList<QRect>& others, const QRect& room, const QSize& least);

// Places a window as stored or, without that, large in the middle of the screen; beside the windows that are
// shown.
void placeWindow(QMainWindow* window, const QByteArray& stored);
