// SPDX-License-Identifier: MIT
#pragma once

#include "io/video/format/video_settings.h"

#include <QByteArray>
#include <QIODevice>

#include <cstdint>
#include <optional>

namespace io {

// Returns true if the text is appended to a complete file of this format; in others it is a tag that the
// encoder writes.
bool hasTextAdded(VideoFormat format);

// Adds the text to a complete GIF, WebP or APNG file of `size` bytes, for readVideoSystem(), where other
// programs pass over it: as a comment, as XMP, as iTXt. The device is open for reading and writing,
// random-access. False when it cannot be read or written, or is no such file.
bool addVideoText(QIODevice& device, qint64 size, VideoFormat format, const QByteArray& text);

// Makes an animation of one frame out of the still picture that the encoder of WebP writes when all pictures
// are the same; it lasts as long as they. The new size of the file; nullopt where the device fails.
std::optional<qint64> animatedWebP(QIODevice& device, qint64 size, const VideoSettings& settings,
                                   std::int64_t pictures);

} // namespace io
