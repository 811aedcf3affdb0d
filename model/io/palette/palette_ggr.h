// SPDX-License-Identifier: MIT
#pragma once

#include "io/palette/palette_file.h"

#include <QByteArrayList>
#include <QString>

namespace io {

// Appends the GIMP gradient (.ggr) in these lines, the first of which is its head, and the problems found in
// it. Opacities are left out; the colours of the toolbox are black and
// white.
void readGimpGradient(const QByteArrayList& lines, QString name, PaletteFile& file);

} // namespace io
