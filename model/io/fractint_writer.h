// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal_file.h"

#include <QByteArray>
#include <QList>

namespace io {

// The file with every untouched entry byte for byte as it was read. Of an edited entry only the edited rows
// and our own comment lines change.
QByteArray writeFractint(const document::FractalFile& file);

// One entry in the strict form that every reader takes; used for new entries and for the clipboard.
QByteArray writeEntry(const document::Fractal& fractal, const QByteArray& lineEnd = "\n");

// What the strictest readers take: unique legal names, weights positive and summing to 1, none of our
// comments. Limits of other programs that are exceeded are reported in `problems`.
struct StrictText {
    QByteArray bytes;
    qsizetype entries = 0; // written; for those that are not, an error is among the problems
    document::Problems problems;
};
StrictText writeStrict(const document::FractalFile& file, const QList<document::EntryId>& only = {});

} // namespace io
