// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

namespace io {

// In place of a path: what is written waits in a file without a name until it is whole, and then goes to
// standard output. Whatever ends the program, nothing is left in the temporary folder. No file is called so.
const QString& standardOutputPath();

// A file without a name, in the temporary folder or else in memory; -1 when there is no room for one.
int namelessFile();

// All of the file, from its beginning; false when it cannot be read or printed.
bool printFile(int descriptor);

} // namespace io
