// SPDX-License-Identifier: MIT
#pragma once

#include "notation/rows/scanner.h"

// Where the entries of a Fractint collection are, which needs no Qt.
namespace io::fractint {

using notation::Block;
using notation::BlockKind;
using notation::holdsOnlyRows;
using notation::isAssignment;
using notation::isBlank;
using notation::lineEnd;
using notation::lineEndByte;
using notation::relative;
using notation::Scanner;
using notation::Span;
using notation::withoutBlanks;
using notation::withoutSpaceMarker;

} // namespace io::fractint
