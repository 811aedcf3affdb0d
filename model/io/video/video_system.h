// SPDX-License-Identifier: MIT
#pragma once

#include "io/file/embedded_system.h"

#include <QByteArray>
#include <QString>

namespace io {

// "mp4", "webm", "mkv", "gif" or "webp", by the first bytes; empty for anything else. An APNG is a PNG
// picture, and readPngSystem() reads it.
QString looksLikeVideo(const QByteArray& bytes);

// The `.ifs` text embedded in a video by VideoWriter. Looks at no picture and trusts no length; a text of
// more than 8 MB is refused; a damaged video gives a failure. FFmpeg's libraries are not needed.
EmbeddedSystem readVideoSystem(const QByteArray& bytes);

} // namespace io
