// SPDX-License-Identifier: MIT
#include "canvas/cage_drag.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace view {

namespace {

constexpr double shortestArm = 40; // pixels; a press nearer to the pivot acts as one at this distance

// v + D(v − pivot): exactly v where the difference D of the transformation from the identity is zero.
ifs::ControlCage<2> transformed(ifs::ControlCage<2> cage, const ifs::Vector<2>& pivot,
                                const ifs::Matrix<2>& difference) {
    for (ifs::Vector<2>& vertex : cage.current)
        vertex += difference * (vertex - pivot);
    return cage;
}

double constrainedAngle(double angle, Constraint constraint) {
    constexpr double step = std::numbers::pi / 12;
    return constraint == Constraint::Constrained ? std::round(angle / step) * step : angle;
}

double angleOf(const CageDrag& drag, const ifs::Vector<2>& offset, double pixelsPerUnit) {
    constexpr double tooNear = 4; // pixels: a press without a direction
    constexpr double perPixel = std::numbers::pi / 360;
    const ifs::Vector<2> from = drag.press - drag.pivot;
    if (from.norm() * pixelsPerUnit < tooNear) return -offset.x() * pixelsPerUnit * perPixel;
    const ifs::Vector<2> to = from + offset;
    return std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
}

// The same factor both ways, by how far the pointer is from the pivot; constrained, along the axis on which
// it has moved farther.
ifs::Vector<2> factorsOf(const CageDrag& drag, const ifs::Vector<2>& offset, Constraint constraint,
                         double pixelsPerUnit) {
    const double shortest = shortestArm / pixelsPerUnit;
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

DragResult moved(const CageDrag& drag, ifs::Vector<2> offset, Constraint constraint,
                 const SnapTargets& targets) {
    if (constraint == Constraint::Constrained)
        (std::abs(offset.x()) < std::abs(offset.y()) ? offset.x() : offset.y()) = 0;
    const auto place = static_cast<std::size_t>(drag.snapVertex);
    const ifs::Vector<2> start = drag.cage.current[place];
    DragResult result{drag.cage, {start + offset}};
    if (!offset.isZero(0)) result.snap = snapped(targets, start + offset);
    // The direction that Shift keeps is kept by the snap too.
    if (constraint == Constraint::Constrained && (result.snap.x || result.snap.y)) {
        const int fixed = offset.x() == 0 ? 0 : 1;
        result.snap.point[fixed] = start[fixed];
        (fixed == 0 ? result.snap.x : result.snap.y) = false;
        result.snap.vertex = false;
    }
    for (const int vertex : drag.vertices)
        result.cage.current[static_cast<std::size_t>(vertex)] += result.snap.point - start;
    if (!offset.isZero(0) && std::ranges::find(drag.vertices, drag.snapVertex) != drag.vertices.end())
        result.cage.current[place] = result.snap.point;
    return result;
}

} // namespace

ifs::ControlCage<2> rotated(ifs::ControlCage<2> cage, const ifs::Vector<2>& pivot, double angle) {
    ifs::Matrix<2> difference;
    difference << std::cos(angle) - 1, -std::sin(angle), std::sin(angle), std::cos(angle) - 1;
    return transformed(std::move(cage), pivot, difference);
}

ifs::ControlCage<2> scaled(ifs::ControlCage<2> cage, const ifs::Vector<2>& pivot,
                           const ifs::Vector<2>& factors) {
    ifs::Matrix<2> difference;
    difference << factors.x() - 1, 0, 0, factors.y() - 1;
    return transformed(std::move(cage), pivot, difference);
}

DragResult dragged(const CageDrag& drag, const ifs::Vector<2>& offset, Constraint constraint,
                   const SnapTargets& targets) {
    const double pixelsPerUnit = targets.camera.pixelsPerUnit;
    switch (drag.mode) {
    case CageDrag::Mode::Move:
        return moved(drag, offset, constraint, targets);
    case CageDrag::Mode::Rotate:
        return {rotated(drag.cage, drag.pivot,
                        constrainedAngle(angleOf(drag, offset, pixelsPerUnit), constraint)),
                {drag.pivot}};
    case CageDrag::Mode::Scale:
        break;
    }
    return {scaled(drag.cage, drag.pivot, factorsOf(drag, offset, constraint, pixelsPerUnit)), {drag.pivot}};
}

} // namespace view
