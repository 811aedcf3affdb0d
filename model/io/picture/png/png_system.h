// SPDX-License-Identifier: MIT
#pragma once

#include "io/file/embedded_system.h"

#include <QByteArray>

namespace io {

// The keyword of the text chunk in which a picture carries its system.
inline constexpr const char* pngSystemKeyword = "Barycage";

bool looksLikePng(const QByteArray& bytes);

// The `.ifs` text embedded in a picture by PngWriter. Reads no pixels, trusts no length: chunks of more than
// 8 MB, or of 40 MB in all, are refused; a damaged picture gives a failure.
EmbeddedSystem readPngSystem(const QByteArray& bytes);

} // namespace io
