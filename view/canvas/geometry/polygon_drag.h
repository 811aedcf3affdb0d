// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "canvas/geometry/snapping.h"
#include "gestures/pointer.h"
#include "ifs/system/affine_map.h"

#include <QPointF>

#include <vector>

namespace view {

// A gesture on the vertices of polygons, as it was when it began. Every position of the pointer is answered
// from this state, so nothing accumulates and the way back is exact.
struct PolygonDrag {
    using Mode = DragMode;

    Mode mode = Mode::Move;
    std::vector<ifs::Vector<2>> points;
    std::vector<int> vertices; // points that move
    ifs::Vector<2> pivot = ifs::Vector<2>::Zero();
    ifs::Vector<2> press = ifs::Vector<2>::Zero(); // point under the pointer
    int snapVertex = 0;                            // vertex that snaps
};

enum class Constraint {
    Free,
    Constrained, // Move and Scale: along one axis; Rotate: steps of 15°
};

struct DragResult {
    std::vector<ifs::Vector<2>> points;
    ifs::AffineMap<2> change; // change of the vertices that move
    Snapped snap;             // target of the snap vertex; none for Rotate and Scale
};

// The points after the pointer has moved by `offset` in the plane. Equal to drag.points when the offset is
// zero. Camera and vertices of `targets` are those of the moment; the camera says how long a pixel is.
DragResult dragged(const PolygonDrag& drag, const ifs::Vector<2>& offset, Constraint constraint,
                   const SnapTargets& targets);

// Moves by numbers, for the keyboard. Angles in radians, counter-clockwise with y up.
DragResult moved(const PolygonDrag& drag, const ifs::Vector<2>& offset);
DragResult rotated(const PolygonDrag& drag, double angle);
DragResult scaled(const PolygonDrag& drag, const ifs::Vector<2>& factors);

} // namespace view
