// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/orbit_camera.h"

#include <QLineF>
#include <QPointF>

#include <optional>

namespace view {

// Depth in front of the eye as a share of the distance of the target; not positive where the point is beside
// the eye or behind it.
double inFront(const attractor::OrbitCamera& camera, const ifs::Vector<3>& point);

// The displayed position of a point, in the pixels of the camera; far outside the view where it is behind the
// eye.
QPointF seenPoint(const attractor::OrbitCamera& camera, const ifs::Vector<3>& point);

// The part of a line in front of the eye and not far outside the view; nullopt if there is none.
std::optional<QLineF> seenLine(const attractor::OrbitCamera& camera, ifs::Vector<3> a, ifs::Vector<3> b);

} // namespace view
