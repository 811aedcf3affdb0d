// SPDX-License-Identifier: MIT
#pragma once

class QWidget;

namespace support {

// Whether a window is active and the X server has it where, and as large as, the program believes: once the
// window manager has framed and placed it, the pointer finds what is in it.
bool isInPlace(const QWidget* window);

} // namespace support
