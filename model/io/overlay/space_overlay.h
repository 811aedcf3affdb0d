// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/request/orbit_camera.h"
#include "document/fractal/fractal.h"
#include "io/overlay/picture_overlay.h"

namespace io {

// The same of an entry in space: the edges of the hull, those of the cage with numbered corners and, for each
// map, those of the image of the tetrahedron that its handles are. Under a cage that bends there is no hull.
// In perspective, what lies behind the eye is left out.
OverlayMarks spaceOverlayMarks(const document::Fractal& fractal, const attractor::OrbitCamera& camera,
                               const PictureOverlay& overlay);

// Points occupied by these marks: the corners of the cage and of the images.
std::vector<ifs::Vector<3>> spaceOverlayPoints(const document::Fractal& fractal,
                                               const PictureOverlay& overlay);

} // namespace io
