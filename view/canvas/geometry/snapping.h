// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/camera.h"
#include "canvas/geometry/grid_spacing.h"

#include <QFlags>

#include <vector>

namespace view {

// Targets that attract a dragged point.
enum class SnapTo {
    Grid = 1,     // lines of the visible grid
    Vertices = 2, // other vertices of the cage, current and at rest
    Axes = 4,     // x = 0 and y = 0
};
Q_DECLARE_FLAGS(Snapping, SnapTo)
Q_DECLARE_OPERATORS_FOR_FLAGS(Snapping)

struct SnapTargets {
    Snapping snapping;
    attractor::Camera camera;
    std::vector<ifs::Vector<2>> vertices; // coordinates in the plane
};

// A snapped point, and the coordinates that a target decided.
struct Snapped {
    ifs::Vector<2> point;
    bool x = false;
    bool y = false;
    bool vertex = false;
};

// `point` drawn to the nearest target within eight pixels: a vertex first, else each coordinate for itself.
// The coordinate taken is exactly that of the target. Unchanged when there is none.
Snapped snapped(const SnapTargets& targets, const ifs::Vector<2>& point);

} // namespace view
