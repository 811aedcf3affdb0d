// SPDX-License-Identifier: MIT
#pragma once

#include "io/palette/palette_file.h"

#include <QByteArray>

namespace io {

// Appends to `file` every `name { gradient: … }` of the text and the problems found in it. A gradient goes
// round a circle of 400 colours; its palette begins at index 0 and ends at index 399. Opacities are left out.
void readUltraFractalGradients(const QByteArray& text, PaletteFile& file);

} // namespace io
