// SPDX-License-Identifier: MIT
#pragma once

#include "io/palette_reader.h"

namespace io {

// Every `name { gradient: … }` of the file. A gradient goes round a circle of 400 places; its palette begins
// at place 0 and ends at place 399. Opacities are left out.
void readUltraFractalGradients(const QByteArray& text, PaletteFile& file);

} // namespace io
