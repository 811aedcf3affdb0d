// SPDX-License-Identifier: MIT
#pragma once

#include "io/video/format/video_format.h"

#include <QByteArray>
#include <QIODevice>

namespace io {

// Adds the text to a complete GIF, WebP or APNG file of `size` bytes, for readVideoSystem(), where other
// programs pass over it: as a comment, as XMP, as iTXt. The device is open for reading and writing,
// random-access. False when it cannot be read or written, or is no such file.
bool addVideoText(QIODevice& device, qint64 size, VideoFormat format, const QByteArray& text);

} // namespace io
