// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/geometry/canvas_part.h"

#include <QCursor>

namespace view {

enum class Holding { No, Yes };

// Open hand over a vertex, closed while it is held; cross over the picture and the empty canvas.
QCursor cursorFor(const CanvasPart& part, Holding holding);

} // namespace view
