// SPDX-License-Identifier: MIT
#pragma once

#include "preferences.h"

namespace view {

// Dresses the whole program in this theme, at once. Quiet text is in every theme the text colour, fainter:
// some desktops leave that role black on black.
void wear(Preferences::Theme theme);

// After the desktop has changed its colours: what is missing in them.
void completePalette();

} // namespace view
