// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/orbit_camera.h"
#include "gestures/pointer.h"

#include <optional>
#include <vector>

namespace view {

// Constraint of the motion of a vertex in space. Axes count from 0.
struct AxisLock {
    enum class Kind {
        View,   // free, in the plane through the point that is parallel to the screen
        Axis,   // along this axis
        Plane,  // plane normal to this axis
        Normal, // line along SpatialDrag::normal
    };
    Kind kind = Kind::View;
    int axis = 0;

    friend bool operator==(const AxisLock&, const AxisLock&) = default;
};

// A drag of a vertex of a cage in space, as it was when it began. Every position of the pointer is answered
// from this state, so nothing accumulates and the way back is exact.
struct SpatialDrag {
    // Move: the vertex; Rotate and Scale: all vertices, about the view axis through their middle or from it.
    using Mode = DragMode;

    attractor::OrbitCamera camera;
    std::vector<ifs::Vector<3>> vertices;
    std::size_t held = 0;
    std::vector<int> together;                       // vertices that move together with the held one
    ifs::Vector<3> normal = ifs::Vector<3>::UnitZ(); // unit length
    ifs::Vector<2> press = ifs::Vector<2>::Zero();   // pixel
    Mode mode = Mode::Move;
};

// The drag of a face: its corners follow its middle, which is held as one more vertex, the last.
SpatialDrag faceDrag(std::vector<ifs::Vector<3>> vertices, const std::vector<int>& corners);

struct Pull {
    ifs::Vector<2> pointer = ifs::Vector<2>::Zero(); // pixel
    double away = 0;                                 // distance pushed from the eye, in units of space
};

// The vertices with the pointer there. Equal to drag.vertices where it was pressed.
std::vector<ifs::Vector<3>> dragged(const SpatialDrag& drag, const Pull& pull, const AxisLock& lock);

// The axis that on the screen comes nearest to the direction of a motion; nullopt without one.
std::optional<int> nearestAxis(const attractor::OrbitCamera& camera, const ifs::Vector<3>& at,
                               const ifs::Vector<2>& motion);

} // namespace view
