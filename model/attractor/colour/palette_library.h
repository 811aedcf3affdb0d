// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/colour/palette.h"

#include <span>
#include <string_view>

namespace attractor {

// A palette that a recipe makes in Oklab from one or two of 24 hues. The parts of its name, for translators:
// `pattern` holds %1 and perhaps %2, which stand for the hues.
struct LibraryPalette {
    Palette palette;
    std::string_view pattern;
    std::string_view hue;
    std::string_view otherHue; // empty if the pattern has no %2
};

// More than two hundred palettes, by recipe and then by hue, with other names than the built-in ones. The
// same bytes on every machine.
std::span<const LibraryPalette> paletteLibrary();
const Palette* findInLibrary(std::string_view name); // ignores case; nullptr if there is none

} // namespace attractor
