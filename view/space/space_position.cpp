// SPDX-License-Identifier: MIT
#include "space/space_position.h"

#include "canvas/geometry/canvas_geometry.h"
#include "document/branches/addresses.h"

#include <algorithm>

namespace view {

SpacePosition positionAt(const document::Fractal& fractal, const SpaceNavigation& navigation,
                         const std::vector<ifs::Vector<3>>& vertices, const QPointF& pixel) {
    SpacePosition at;
    const attractor::OrbitCamera& camera = navigation.camera();
    const auto point = navigation.pointUnder(pixel);
    at.onAttractor = point.has_value();
    at.world = point.value_or(toWorld(camera, {toVector(navigation.inEye(pixel)), 0}));
    at.depth = toScreen(camera, at.world).depth;
    at.unitsPerPixel = 1 / pixelsPerUnit(camera);
    if (point) at.address = document::addressInSpace(fractal, at.world, at.unitsPerPixel);
    ifs::Simplex<3> simplex;
    if (vertices.size() == simplex.size()) {
        std::ranges::copy(vertices, simplex.begin());
        if (ifs::isAffineBasis<3>(simplex)) at.barycentric = ifs::barycentric<3>(simplex, at.world);
    }
    return at;
}

} // namespace view
