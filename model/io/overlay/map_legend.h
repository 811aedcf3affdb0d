// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal.h"

#include <QImage>

namespace io {

// The table of the maps of a system in the plane, to stand beside a picture of that height: its name, then a
// row for each map with number, colour, a to f and the probability used, to four digits. As many rows as
// there is room for, and how many more there are. On the background of the picture, or on white if that is
// transparent; as wide as it needs to be. Needs a QGuiApplication for the letters.
QImage mapLegend(const document::Fractal& fractal, int height);

} // namespace io
