// SPDX-License-Identifier: MIT
#pragma once

#include <QChar>

// Characters of Unicode's bidirectional algorithm, which are not seen themselves.
namespace document {

// Embeddings, overrides and isolates: they could show a text in another order than it is written.
inline bool reordersText(QChar c) {
    const char16_t code = c.unicode();
    return (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
}

// Returns true also for the marks by which a name could reverse the text behind it.
inline bool turnsText(QChar c) {
    const char16_t code = c.unicode();
    return code == 0x061c || code == 0x200e || code == 0x200f || reordersText(c);
}

} // namespace document
