// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

namespace cli {

// "-", in place of a file.
bool isStandardOutput(const QString& output);

// Whether both names lead to one file that exists.
bool isSameFile(const QString& a, const QString& b);

} // namespace cli
