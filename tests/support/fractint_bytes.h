// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal_file.h"

namespace support {

// The bytes a file was read from, put together from its parts.
inline QByteArray joined(const document::FractalFile& file) {
    QByteArray bytes = file.head;
    for (const document::Entry& entry : file.entries)
        if (entry.source) bytes += entry.source->before + entry.source->text;
    return bytes + file.tail;
}

} // namespace support
