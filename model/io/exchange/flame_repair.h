// SPDX-License-Identifier: MIT
#pragma once

#include "document/problem.h"

#include <QString>

namespace io {

struct RepairedFlames {
    QString text;                // repaired XML with the same lines
    document::Problems problems; // repairs, and flames that could not be repaired
};

// Well-formed XML stays as it is, but for a flame of JWildfire that has one layer, which becomes a flame
// without. In any other, what damaged flames have in common is mended: no blank behind an attribute, an
// ampersand that stands for itself, an attribute there twice (the first counts). A flame that is still
// damaged is left out, so that the next one is read; text with a document type stays as it is.
RepairedFlames repairedFlames(const QString& text);

} // namespace io
