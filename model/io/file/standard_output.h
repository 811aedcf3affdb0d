// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include <cstddef>

namespace io {

// In place of a path: what is written waits in a file without a name until it is whole, and then goes to
// standard output. Whatever ends the program, nothing is left in the temporary folder. No file is called so.
const QString& standardOutputPath();

// The sentence for an error of the system.
QString cannotPrint(int error);

// A file without a name, in the temporary folder or else in memory; -1 with errno when there is no room for
// one.
int namelessFile();

// All of it to standard output, waiting where that is a pipe that does not block; false with errno when it
// cannot be written to.
bool printBytes(const char* data, std::size_t size);

// All of the file, from its beginning; false with errno when it cannot be read or printed.
bool printFile(int descriptor);

} // namespace io
