// SPDX-License-Identifier: MIT
#include "space/seen_line.h"

#include <algorithm>
#include <cmath>

namespace view {

namespace {

constexpr double far = 1e5; // pixels; clips lines that would be slow to paint

using attractor::OrbitCamera;
using ifs::Vector;

} // namespace

double inFront(const OrbitCamera& camera, const Vector<3>& point) {
    constexpr double nearest = 1e-3;
    if (camera.projection == OrbitCamera::Projection::Orthographic) return 1;
    return 1 + toScreen(camera, point).depth / eyeDistance(camera) - nearest;
}

QPointF seenPoint(const OrbitCamera& camera, const Vector<3>& point) {
    const Vector<2> pixel = toScreen(camera, point).pixel;
    if (!pixel.allFinite()) return {-far, -far};
    return {std::clamp(pixel.x(), -far, far), std::clamp(pixel.y(), -far, far)};
}

std::optional<QLineF> seenLine(const OrbitCamera& camera, Vector<3> a, Vector<3> b) {
    const double first = inFront(camera, a), last = inFront(camera, b);
    if (!(first > 0) && !(last > 0)) return std::nullopt;
    const Vector<3> edge = b - a;
    if (!(last > 0)) b = a + first / (first - last) * edge;
    if (!(first > 0)) a += first / (first - last) * edge;
    const Vector<2> from = toScreen(camera, a).pixel, to = toScreen(camera, b).pixel;
    double begin = 0, end = 1;
    for (int axis = 0; axis < 2; ++axis) {
        const double way = to[axis] - from[axis];
        if (way == 0 && std::abs(from[axis]) > far) return std::nullopt;
        if (way == 0) continue;
        const auto [enter, leave] = std::minmax({(-far - from[axis]) / way, (far - from[axis]) / way});
        begin = std::max(begin, enter);
        end = std::min(end, leave);
    }
    if (!(begin <= end)) return std::nullopt;
    const QLineF line(from.x(), from.y(), to.x(), to.y());
    return QLineF(begin == 0 ? line.p1() : line.pointAt(begin), end == 1 ? line.p2() : line.pointAt(end));
}

} // namespace view
