// SPDX-License-Identifier: MIT
#pragma once

#include "document/problem.h"

#include <QString>

// Messages on standard error: "file:line:column: error: sentence", one per line.
namespace cli {

// Lines of text without control characters, with which a name out of a file could command the terminal, and
// without those that turn its direction. A byte of a file's name that is not UTF-8 is shown as \xe4.
QString printable(QString text);
QString printableLine(QString text); // also without line ends

void hideWarnings(bool areHidden = true); // affects later warnings only

void report(const document::Problem& problem, const QString& fileName);
void reportError(const QString& fileName, const QString& sentence);
void reportWarning(const QString& fileName, const QString& sentence);
// Wrong usage, with a hint where to find the right one.
void reportUsage(const QString& subcommand, const QString& sentence);

// Writes to standard output; false if that fails, with errno.
[[nodiscard]] bool print(const QByteArray& text);

} // namespace cli
