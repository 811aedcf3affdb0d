// SPDX-License-Identifier: MIT
#pragma once

#include "io/palette/palette_file.h"

#include <QByteArray>
#include <QString>

// Palettes of other programs. docs/formats.md, "Palettes".
namespace io {

// Reads GIMP palettes (.gpl) and gradients (.ggr), Ultra Fractal gradients (.ugr) and Fractint colour maps
// (.map), distinguished by their content. `name` is for palettes that carry none. Colours come back to the
// nearest of 256 levels or the next.
PaletteFile readPalettes(const QByteArray& bytes, const QString& name);

// A .gpl file: 256 colours for every program, and the stops in comments for readPalettes().
QByteArray writeGimpPalette(const attractor::Palette& palette);

} // namespace io
