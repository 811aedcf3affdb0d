// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/colour/palette.h"

#include <QString>

#include <vector>

namespace view {

// The name of a palette in the user's language, where it is one that comes with the program; else its own,
// which may be empty.
QString paletteTitle(const attractor::Palette& palette);
bool isOfLibrary(const attractor::Palette& palette);

// The titles of all palettes that come with the program: the built-in ones, then those of the library.
struct TitledPalette {
    attractor::Palette palette;
    QString title;
};
std::vector<TitledPalette> titledPalettes();

} // namespace view
