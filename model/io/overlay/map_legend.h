// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <QImage>

namespace io {

// The table of the maps of an entry with a system, to stand beside a picture of that height: its name, then a
// row for each map with number, colour, the numbers of its code (a to f, in space a to l) and the probability
// used, to four digits. As many rows as there is room for, and how many more there are. On the background of
// the picture, or on white if that is transparent; as wide as it needs to be. Needs a QGuiApplication for the
// letters.
QImage mapLegend(const document::Fractal& fractal, int height);

} // namespace io
