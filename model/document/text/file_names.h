// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

// Texts of any kind, such as the names of entries, where they become names of files or lines of one.
namespace document {

inline constexpr qsizetype maxFileName = 255; // bytes, the limit of most file systems

// The longest beginning of the text that takes at most `bytes` bytes in UTF-8.
QString cutTo(QString text, qsizetype bytes);

// The text as a part of the name of a file: at most `maxBytes` bytes in UTF-8, never empty. Characters that
// lead to another folder, hide the file, end a line, are invisible, or change the order in which a name is
// read become underscores.
QString fileNamePart(const QString& text, qsizetype maxBytes = maxFileName);

// The text on one line, in which such characters become underscores; slashes and points stay.
QString oneLine(const QString& text);

} // namespace document
