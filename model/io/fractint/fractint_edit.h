// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal_file.h"

#include <QByteArray>

namespace io::fractint {

// The entry's text with the edit worked into it: bytes that say nothing new stay (spelling of unchanged
// numbers, gaps, comments, line ends). What cannot be said by such changes is written afresh, in the form of
// writeEntry.
QByteArray editedText(const document::EntrySource& source, const document::Fractal& fractal);

// The text of a bare file given a name and braces.
document::EntrySource withBraces(const document::EntrySource& bare);
bool isBare(const document::EntrySource& source);

} // namespace io::fractint
