// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/orbit_camera.h"
#include "ifs/system/barycentric.h"
#include "ifs/system/branch.h"
#include "space/space_navigation.h"
#include "space/spatial_drag.h"

#include <QMetaType>

#include <optional>
#include <vector>

namespace view {

// The point under the pointer in space.
struct SpacePosition {
    ifs::Vector<3> world = ifs::Vector<3>::Zero();
    double depth = 0;         // distance along the view away from the eye; 0 in the plane of the target
    double unitsPerPixel = 1; // scale in the plane of the target
    bool onAttractor = false; // false: in the plane of the target
    // Coordinates with respect to the current tetrahedron; nullopt while it is flat.
    std::optional<ifs::Barycentric<3>> barycentric;
    ifs::Word address; // address of the point of the attractor, outermost map first; empty: none
    AxisLock lock;     // lock of the dragged corner
    std::optional<attractor::Direction> direction; // direction of the camera while it turns about `world`
};

// The point at a pixel of the view, with respect to a tetrahedron of these vertices, if it is one.
SpacePosition positionAt(const document::Fractal& fractal, const SpaceNavigation& navigation,
                         const std::vector<ifs::Vector<3>>& vertices, const QPointF& pixel);

} // namespace view

Q_DECLARE_METATYPE(view::SpacePosition)
