// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/camera.h"
#include "canvas/snapping.h"
#include "ifs/control_cage.h"

#include <QPointF>

#include <vector>

namespace view {

// One gesture on a cage, as it was when it began. Every position of the pointer is answered from here, so
// nothing accumulates and the way back is exact.
struct CageDrag {
    enum class Mode { Move, Rotate, Scale };

    Mode mode = Mode::Move;
    std::vector<int> vertices; // those that move
    ifs::ControlCage<2> cage;
    ifs::Vector<2> pivot = ifs::Vector<2>::Zero();
    ifs::Vector<2> press = ifs::Vector<2>::Zero(); // what was under the pointer
    int snapVertex = 0;                            // the vertex that is drawn to snap targets
};

enum class Constraint {
    Free,
    Constrained, // Move and Scale: along one axis; Rotate: steps of 15°
};

struct DragResult {
    ifs::ControlCage<2> cage;
    Snapped snap; // of the snap vertex; snapped nowhere for Rotate and Scale
};

// The cage after the pointer has moved by `offset` in the plane. Equal to drag.cage when the offset is zero.
// Camera and vertices of `targets` are those of the moment; the camera says how long a pixel is.
DragResult dragged(const CageDrag& drag, const ifs::Vector<2>& offset, Constraint constraint,
                   const SnapTargets& targets);

// About the pivot, from rest: used by the keyboard too. Angle in radians, counter-clockwise with y up.
ifs::ControlCage<2> rotated(ifs::ControlCage<2> cage, const ifs::Vector<2>& pivot, double angle);
ifs::ControlCage<2> scaled(ifs::ControlCage<2> cage, const ifs::Vector<2>& pivot,
                           const ifs::Vector<2>& factors);

} // namespace view
