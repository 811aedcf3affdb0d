// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/palette.h"
#include "document/problem.h"

#include <QByteArray>
#include <QString>

#include <vector>

// Palettes of other programs. docs/formats.md, "Palettes".
namespace io {

struct PaletteFile {
    std::vector<attractor::Palette> palettes; // empty only with an error among the problems
    document::Problems problems;
};

// GIMP palettes (.gpl), Ultra Fractal gradients (.ugr), Fractint colour maps (.map), told apart by what they
// hold. `name` is for palettes that carry none. Colours come back to the nearest of 256 levels or the next.
PaletteFile readPalettes(const QByteArray& bytes, const QString& name);

// As a .gpl file: 256 colours for every program, and the stops in comments for readPalettes().
QByteArray writeGimpPalette(const attractor::Palette& palette);

} // namespace io
