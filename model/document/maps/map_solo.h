// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <QString>

// Showing one map alone: w_i(A), the part of the attractor that it makes, while the rest is not drawn.
// docs/decisions/0026.
namespace document {

// Why the map cannot be shown alone, as a sentence; empty where it can.
QString soloObstacle(const Fractal& fractal, ifs::MapId map);

// A fractal that draws the image of the attractor under this map, in the place and in the colours that it has
// in the whole picture. For drawing only: its cage or its moved branches are others. Returns the fractal
// itself if there is an obstacle.
Fractal soloed(Fractal fractal, ifs::MapId map);

} // namespace document
