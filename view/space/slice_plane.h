// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/orbit_camera.h"
#include "attractor/request/space_appearance.h"

#include <array>
#include <optional>
#include <vector>

namespace view {

// The plane by which a clip is held: the middle of a slice, the border of a half-space.
struct SlicePlane {
    ifs::Vector<3> centre = ifs::Vector<3>::Zero();
    ifs::Vector<3> normal = ifs::Vector<3>::UnitX(); // unit length
    std::array<ifs::Vector<3>, 4> corners;           // corners of a square around the centre
};

// A plane as large as the sliced object: about the centre of these points, with their reach. At least one
// point.
SlicePlane slicePlane(const attractor::SpaceClip& clip, const std::vector<ifs::Vector<3>>& around);

// The clip moved along its normal, in units of space.
attractor::SpaceClip slid(attractor::SpaceClip clip, double distance);

// Distance along the normal by which a drag between two pixels moves the plane: to the point of the line
// through the centre that is closest to the line of sight. If one looks along the normal, up and down move it
// away and back.
double slideBetween(const attractor::OrbitCamera& camera, const SlicePlane& plane, const ifs::Vector<2>& from,
                    const ifs::Vector<2>& to);

} // namespace view
