// SPDX-License-Identifier: MIT
#include "ifs/copies/copy_frame.h"

#include "ifs/extent/convex_hull.h"

#include <algorithm>
#include <cmath>

namespace ifs {

namespace {

constexpr double hullTolerance = 2e-3; // relative to the radius

Vector<2> middleOf(const Polygon& points) {
    Vector<2> sum = Vector<2>::Zero();
    for (const auto& p : points)
        sum += p;
    return sum / double(points.size());
}

} // namespace

std::optional<CopyFrame> CopyFrame::of(const std::vector<AffineMap<2>>& maps, const AffineMap<2>& display) {
    const auto support = SupportFunction<2>::of(maps);
    if (!support) return std::nullopt;
    CopyFrame frame;
    frame.pixel = 1 / std::max(spectralNorm<2>(display.linear), 1e-300);
    const double tolerance = std::max(hullTolerance * support->radius(), 1e-3 * frame.pixel);
    const ConvexHull hull = ifs::convexHull(*support, tolerance);
    frame.hull = ifs::convexHull(hull.vertices, 0);
    frame.hullError = std::max(hull.error, tolerance);
    frame.diameter = ifs::diameter(frame.hull);
    if (!std::isfinite(frame.diameter) || frame.hull.empty()) return std::nullopt;
    frame.centre = middleOf(frame.hull);
    frame.thinness = minThickness * frame.pixel / std::max(frame.diameter, frame.pixel);
    return frame;
}

double diameter(const Polygon& polygon) {
    double longest = 0;
    for (const auto& a : polygon)
        for (const auto& b : polygon)
            longest = std::max(longest, (a - b).norm());
    return longest;
}

Polygon pushedOut(const Polygon& polygon, double distance) {
    Polygon result;
    const std::size_t n = polygon.size();
    if (n < 3) {
        const Vector<2>& a = polygon.front();
        const Vector<2>& b = polygon.back();
        const Vector<2> along = n == 2 ? Vector<2>((b - a).normalized()) : Vector<2>(1, 0);
        const Vector<2> u = distance * along;
        const Vector<2> v(-u.y(), u.x());
        return {a - u - v, b + u - v, b + u + v, a - u + v};
    }
    const auto outward = [&](std::size_t i) { // outward normal of the edge from vertex i
        const Vector<2> edge = polygon[(i + 1) % n] - polygon[i % n];
        return Vector<2>(Vector<2>(edge.y(), -edge.x()).normalized());
    };
    for (std::size_t i = 0; i < n; ++i) {
        const Vector<2> before = outward(i + n - 1);
        const Vector<2> after = outward(i);
        const double cosine = before.dot(after);
        if (cosine > -0.5) {
            result.push_back(polygon[i] + distance * (before + after) / (1 + cosine));
            continue;
        }
        // Two vertices for a sharp corner, which would stick out far: a square around its end.
        const Vector<2> tip = (before + after).normalized() * distance;
        result.push_back(polygon[i] + distance * before + tip);
        result.push_back(polygon[i] + distance * after + tip);
    }
    return result;
}

double maxShift(const CopyFrame& frame, const AffineMap<2>& a, const AffineMap<2>& b) {
    const AffineMap<2> difference{a.linear - b.linear, a.translation - b.translation};
    double furthest = difference(frame.centre).norm();
    for (const auto& point : frame.hull)
        furthest = std::max(furthest, difference(point).norm());
    return furthest + spectralNorm<2>(difference.linear) * frame.hullError;
}

} // namespace ifs
