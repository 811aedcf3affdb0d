// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal_file.h"

#include <QByteArray>
#include <QList>

namespace io {

// A collection that the strictest readers take: unique legal names, weights positive and summing to 1, none
// of our comments. Limits of other programs that are exceeded are reported in `problems`.
struct StrictText {
    QByteArray bytes;
    qsizetype entries = 0; // number written; each other entry has an error among the problems
    document::Problems problems;
};
// Writes all entries with the head and tail of the file, or those of `only` alone.
StrictText writeStrict(const document::FractalFile& file, const QList<document::EntryId>& only = {});

} // namespace io
