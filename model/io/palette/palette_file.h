// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/colour/palette.h"
#include "document/problem.h"

#include <vector>

namespace io {

// Palettes read from a file, whichever program wrote it.
struct PaletteFile {
    std::vector<attractor::Palette> palettes; // empty only if there is an error among the problems
    document::Problems problems;
};

} // namespace io
