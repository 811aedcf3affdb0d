// SPDX-License-Identifier: MIT
#include "io/picture/decoding/jpeg_check.h"

namespace io {

namespace {

constexpr int startOfScan = 0xDA;

int byteAt(const QByteArray& bytes, qsizetype index) {
    return index < bytes.size() ? int(static_cast<unsigned char>(bytes[index])) : -1;
}

bool isFrameHeader(int marker) {
    return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

// The place of the second byte of the next marker at or behind the index, past coded data.
qsizetype nextMarker(const QByteArray& bytes, qsizetype index) {
    for (; index + 1 < bytes.size(); ++index) {
        const int code = byteAt(bytes, index + 1);
        // Markers below C0 have no length; libraries skip them or refuse the file.
        const bool isData = code < 0xC0 || code == 0xFF || (code >= 0xD0 && code <= 0xD7);
        if (byteAt(bytes, index) == 0xFF && !isData) return index + 1;
    }
    return bytes.size();
}

} // namespace

JpegFacts jpegFacts(const QByteArray& bytes) {
    JpegFacts facts;
    for (qsizetype at = nextMarker(bytes, 2); at < bytes.size();) {
        const int marker = byteAt(bytes, at);
        if (marker == 0xD9) {
            facts.isComplete = true;
            return facts;
        }
        const int length = byteAt(bytes, at + 1) * 256 + byteAt(bytes, at + 2);
        if (length < 2) return facts;
        if (isFrameHeader(marker) && facts.components == 0) {
            facts.components = byteAt(bytes, at + 8);
            facts.isKept = (marker & 3) == 2; // progressive mode
        }
        if (marker == startOfScan) {
            ++facts.scans;
            facts.isKept = facts.isKept || byteAt(bytes, at + 3) < facts.components;
        }
        at = nextMarker(bytes, at + 1 + length);
    }
    return facts;
}

} // namespace io
