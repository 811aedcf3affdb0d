// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal_file.h"

// What the program can be asked to do with a file that it has read.
namespace fuzz {

// Ends the program when it is broken.
void promise(bool kept, const char* what);

// Writes the first systems of the file in every format of text, which must read back with the same maps. Of
// some of them, a drawing, a report or the facts are made in a little time: every number must be one, and
// nothing that is certified may contradict what is easily known.
void checkHandled(const document::FractalFile& file);

} // namespace fuzz
