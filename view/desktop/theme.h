// SPDX-License-Identifier: MIT
#pragma once

#include "desktop/preferences.h"

namespace view {

// Shows all windows in this theme, at once. Placeholder text has the text colour, fainter, in every theme:
// some desktops leave that role black on black.
void applyTheme(Preferences::Theme theme);

// Fills in missing colours after the desktop has changed its own.
void completePalette();

} // namespace view
