// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>

namespace io {

struct JpegFacts {
    bool isComplete = false; // true if it has its end marker
    int components = 0;      // 1 grey, 3 colours, 4 CMYK; 0 without a frame header
    int scans = 0;           // number of passes over the whole picture
    bool isKept = false; // true if decoders must hold all of it until the last scan, instead of reading rows
};
// Reads the markers alone; the bytes must begin as a JPEG file does.
JpegFacts jpegFacts(const QByteArray& bytes);

} // namespace io
