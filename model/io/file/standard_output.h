// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include <cstddef>

namespace io {

// A pseudo path: output waits in a file without a name until it is complete, and then goes to standard
// output. Whatever ends the program, nothing is left in the temporary folder. No file has this name.
const QString& standardOutputPath();

// The sentence for an error of the system.
QString cannotPrint(int error);

// A file without a name, in the temporary folder or else in memory; -1 with errno when there is no room for
// one.
int namelessFile();

// Writes all bytes to standard output, waiting where that is a non-blocking pipe; false with errno when it
// cannot be written to.
bool printBytes(const char* data, std::size_t size);

// Writes the whole file, from its beginning; false with errno when it cannot be read or printed.
bool printFile(int descriptor);

} // namespace io
