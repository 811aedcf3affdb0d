// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>

namespace io {

struct JpegFacts {
    bool isComplete = false; // it has its end marker
    int components = 0;      // 1 grey, 3 colours, 4 CMYK; 0 without a frame header
    int scans = 0;           // each goes over all of the picture
    bool isKept = false;     // until the last scan has come: it is not read row by row
};
// Reads the markers alone; the bytes must begin as a JPEG file does.
JpegFacts jpegFacts(const QByteArray& bytes);

} // namespace io
