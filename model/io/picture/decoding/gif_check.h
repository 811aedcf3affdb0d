// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>

namespace io {

// Returns true if the codes of a GIF's first picture stand for far more pixels than it has: each code of 12
// bits may stand for thousands. The bytes must begin as a GIF file does; later bytes that are not GIF are not
// judged.
bool isSwollenGif(const QByteArray& bytes);

} // namespace io
