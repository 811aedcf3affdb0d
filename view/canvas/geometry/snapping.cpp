// SPDX-License-Identifier: MIT
#include "canvas/geometry/snapping.h"

#include <cmath>
#include <optional>

namespace view {

namespace {

constexpr double reach = 8; // pixels

// The nearest of the allowed lines for one coordinate, if near enough.
std::optional<double> line(const SnapTargets& targets, double coordinate, double near) {
    if (targets.snapping.testFlag(SnapTo::Axes) && std::abs(coordinate) <= near) return 0.0;
    if (!targets.snapping.testFlag(SnapTo::Grid)) return std::nullopt;
    const double step = gridSpacing(targets.camera.pixelsPerUnit).minor;
    // Converted like the text of the label, so that the tenth line of 0.1 is 1 and the third 0.3.
    const double nearest = gridLabel(step, std::round(coordinate / step)).toDouble();
    if (std::abs(nearest - coordinate) > near) return std::nullopt;
    return nearest;
}

} // namespace

Snapped snapped(const SnapTargets& targets, const ifs::Vector<2>& point) {
    const double near = reach / targets.camera.pixelsPerUnit;
    Snapped result{point};
    if (targets.snapping.testFlag(SnapTo::Vertices)) {
        double nearest = near;
        for (const ifs::Vector<2>& vertex : targets.vertices) {
            const double distance = (vertex - point).norm();
            if (distance <= nearest) {
                nearest = distance;
                result = {vertex, true, true, true};
            }
        }
        if (result.vertex) return result;
    }
    if (const std::optional<double> x = line(targets, point.x(), near)) {
        result.point.x() = *x;
        result.x = true;
    }
    if (const std::optional<double> y = line(targets, point.y(), near)) {
        result.point.y() = *y;
        result.y = true;
    }
    return result;
}

} // namespace view
