// SPDX-License-Identifier: MIT
#pragma once

#include "canvas/geometry/polygon_drag.h"

#include <QString>

namespace view {

// `what` a drag does, and to what value: "Move vertex 2 to (1.2, 3)".
QString withValue(const QString& what, const PolygonDrag& drag, const DragResult& result);

// The result of a drag so far, in a line or two: the angle, the factor, or the distance and direction. For
// one vertex of a polygon also the lengths of its edges, for an edge its length.
QString readout(const PolygonDrag& drag, const DragResult& result);

} // namespace view
