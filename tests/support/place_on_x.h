// SPDX-License-Identifier: MIT
#pragma once

class QWidget;

namespace support {

// Whether a window has the keyboard, and the X server has it where, and as large as, the program believes:
// once the window manager has framed and placed it, keys and the pointer find what is in it.
bool isInPlace(const QWidget* window);

} // namespace support
