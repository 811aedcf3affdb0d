// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>

namespace io {

// Whether the pixels of the first picture of a GIF, as its codes say, are far more than it has: each code of
// 12 bits may stand for thousands. The bytes must begin as a GIF file does; what is no GIF further on is not
// judged.
bool isSwollenGif(const QByteArray& bytes);

} // namespace io
