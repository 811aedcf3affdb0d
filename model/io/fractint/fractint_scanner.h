// SPDX-License-Identifier: MIT
#pragma once

#include "entry/rows/scanner.h"

// Where the entries of a Fractint collection are, which needs no Qt.
namespace io::fractint {

using entry::Block;
using entry::BlockKind;
using entry::holdsOnlyRows;
using entry::isAssignment;
using entry::isBlank;
using entry::lineEnd;
using entry::lineEndByte;
using entry::relative;
using entry::Scanner;
using entry::Span;
using entry::withoutBlanks;
using entry::withoutSpaceMarker;

} // namespace io::fractint
