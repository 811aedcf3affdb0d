// SPDX-License-Identifier: MIT
#include "canvas/scene/symmetry_layout.h"

#include "canvas/geometry/canvas_geometry.h"
#include "document/fractal/fractal_geometry.h"
#include "ifs/cage/map_handles.h"

#include <Eigen/LU>

#include <cmath>
#include <numbers>

namespace view {

namespace {

constexpr double spoke = 26;   // pixels, like all lengths here
constexpr double mirror = 110; // half the length of a line
const QPointF aside(30, -30);  // offset of the handle from the centre

QPointF unit(const QPointF& direction) {
    const double length = std::hypot(direction.x(), direction.y());
    return length > 0 ? direction / length : QPointF();
}

} // namespace

std::optional<SymmetryMarks> symmetryLayout(const document::Fractal& fractal,
                                            const attractor::Camera& camera) {
    const document::System2* system = document::system2(fractal);
    if (!system || system->symmetry.group == ifs::SymmetryGroup::None) return std::nullopt;
    const ifs::Symmetry<2>& symmetry = system->symmetry;
    const ifs::Placement placement = document::placement(fractal);
    const ifs::AffineMap<2> near = ifs::firstOrder(placement, symmetry.centre);
    SymmetryMarks marks;
    marks.centre = pixelOf(camera, placement(symmetry.centre));
    marks.knob = marks.centre + aside;
    // Direction on the screen of a line at this angle in the standard position of the group.
    const auto direction = [&](double degrees) {
        const double angle = (symmetry.angle + degrees) * std::numbers::pi / 180;
        const ifs::Vector<2> along =
            near.linear * symmetry.frame * ifs::Vector<2>(std::cos(angle), std::sin(angle));
        const QPointF pixels = pixelOf(camera, placement(symmetry.centre) + along) - marks.centre;
        return unit(pixels);
    };
    const bool hasMirrors = symmetry.group != ifs::SymmetryGroup::Rotation;
    for (int k = 0; k < symmetry.order; ++k) {
        if (hasMirrors) {
            const QPointF along = direction(180.0 * k / symmetry.order) * mirror;
            marks.mirrors.emplace_back(marks.centre - along, marks.centre + along);
        } else {
            marks.spokes << marks.centre + direction(360.0 * k / symmetry.order) * spoke;
        }
    }
    return marks;
}

} // namespace view
