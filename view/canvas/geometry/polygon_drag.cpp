// SPDX-License-Identifier: MIT
#include "canvas/geometry/polygon_drag.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace view {

namespace {

constexpr double minArm = 40; // pixels; a press nearer to the pivot counts as one at this distance

// v + D(v − pivot): exactly v where the difference D of the transformation from the identity is zero.
DragResult transformed(const PolygonDrag& drag, const ifs::Matrix<2>& difference) {
    DragResult result{
        drag.points, {ifs::Matrix<2>::Identity() + difference, -difference * drag.pivot}, {drag.pivot}};
    for (ifs::Vector<2>& point : result.points)
        point += difference * (point - drag.pivot);
    return result;
}

double constrainedAngle(double angle, Constraint constraint) {
    constexpr double step = std::numbers::pi / 12;
    return constraint == Constraint::Constrained ? std::round(angle / step) * step : angle;
}

double angleOf(const PolygonDrag& drag, const ifs::Vector<2>& offset, double pixelsPerUnit) {
    constexpr double tooNear = 4; // pixels; a nearer press has no direction
    constexpr double perPixel = std::numbers::pi / 360;
    const ifs::Vector<2> from = drag.press - drag.pivot;
    if (from.norm() * pixelsPerUnit < tooNear) return -offset.x() * pixelsPerUnit * perPixel;
    const ifs::Vector<2> to = from + offset;
    return std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
}

// The same factor both ways, by how far the pointer is from the pivot; constrained, along the axis on which
// it has moved farther.
ifs::Vector<2> factorsOf(const PolygonDrag& drag, const ifs::Vector<2>& offset, Constraint constraint,
                         double pixelsPerUnit) {
    const double shortest = minArm / pixelsPerUnit;
    const ifs::Vector<2> arm = drag.press - drag.pivot;
    if (constraint == Constraint::Free) {
        const double length = arm.norm();
        const ifs::Vector<2> direction = length > 0 ? ifs::Vector<2>(arm / length) : ifs::Vector<2>(1, 0);
        return ifs::Vector<2>::Constant(1 + direction.dot(offset) / std::max(length, shortest));
    }
    const int axis = std::abs(offset.x()) < std::abs(offset.y()) ? 1 : 0;
    ifs::Vector<2> factors(1, 1);
    factors[axis] += offset[axis] / std::copysign(std::max(std::abs(arm[axis]), shortest), arm[axis]);
    return factors;
}

DragResult snapping(const PolygonDrag& drag, ifs::Vector<2> offset, Constraint constraint,
                    const SnapTargets& targets) {
    if (constraint == Constraint::Constrained)
        (std::abs(offset.x()) < std::abs(offset.y()) ? offset.x() : offset.y()) = 0;
    if (offset.isZero(0)) return moved(drag, offset);
    const auto index = static_cast<std::size_t>(drag.snapVertex);
    const ifs::Vector<2> start = drag.points[index];
    Snapped snap = snapped(targets, start + offset);
    // Snaps along the direction that Shift keeps.
    if (constraint == Constraint::Constrained && (snap.x || snap.y)) {
        const int fixed = offset.x() == 0 ? 0 : 1;
        snap.point[fixed] = start[fixed];
        (fixed == 0 ? snap.x : snap.y) = false;
        snap.vertex = false;
    }
    DragResult result = moved(drag, snap.point - start);
    if (std::ranges::find(drag.vertices, drag.snapVertex) != drag.vertices.end())
        result.points[index] = snap.point;
    result.snap = snap;
    return result;
}

} // namespace

DragResult moved(const PolygonDrag& drag, const ifs::Vector<2>& offset) {
    DragResult result{drag.points, {ifs::Matrix<2>::Identity(), offset}, {}};
    for (const int vertex : drag.vertices)
        result.points[static_cast<std::size_t>(vertex)] += offset;
    result.snap.point = result.points[static_cast<std::size_t>(drag.snapVertex)];
    return result;
}

DragResult rotated(const PolygonDrag& drag, double angle) {
    ifs::Matrix<2> difference;
    difference << std::cos(angle) - 1, -std::sin(angle), std::sin(angle), std::cos(angle) - 1;
    return transformed(drag, difference);
}

DragResult scaled(const PolygonDrag& drag, const ifs::Vector<2>& factors) {
    ifs::Matrix<2> difference;
    difference << factors.x() - 1, 0, 0, factors.y() - 1;
    return transformed(drag, difference);
}

DragResult dragged(const PolygonDrag& drag, const ifs::Vector<2>& offset, Constraint constraint,
                   const SnapTargets& targets) {
    const double pixelsPerUnit = targets.camera.pixelsPerUnit;
    switch (drag.mode) {
    case PolygonDrag::Mode::Move:
        return snapping(drag, offset, constraint, targets);
    case PolygonDrag::Mode::Rotate:
        return rotated(drag, constrainedAngle(angleOf(drag, offset, pixelsPerUnit), constraint));
    case PolygonDrag::Mode::Scale:
        break;
    }
    return scaled(drag, factorsOf(drag, offset, constraint, pixelsPerUnit));
}

} // namespace view
