// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <QString>

// One map alone: w_i(A), the part of the attractor that it makes, while the rest is not drawn.
// docs/decisions/0026.
namespace document {

// Why the map cannot be shown alone, as a sentence; empty where it can.
QString soloObstacle(const Fractal& fractal, ifs::MapId map);

// What draws the image of the attractor under this map, in the place and in the colours that it has in the
// whole picture. Only to be drawn: its cage or its moved branches are others. The fractal as it is where
// there is an obstacle to it.
Fractal soloed(Fractal fractal, ifs::MapId map);

} // namespace document
