// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

namespace cli {

// "-", in place of a file.
bool isStandardOutput(const QString& output);

// The file that an input names; of "-", the one that the shell has opened, if it is one.
QString fileBehind(const QString& input);

// Returns true if writing to `output`, a file or "-", would replace that file: the shell may have opened it
// for both.
bool isReplacedBy(const QString& output, const QString& input);

// Returns true if both names lead to one file that exists.
bool isSameFile(const QString& a, const QString& b);

} // namespace cli
