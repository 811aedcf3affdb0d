// SPDX-License-Identifier: MIT
#include "ifs/support_function.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ifs {

namespace {

using Points = std::vector<Vector<2>>;

constexpr std::size_t MaxVertices = 20'000;
constexpr int NodesPerEdge = 20'000;

double cross(const Vector<2>& p, const Vector<2>& q) {
    return p.x() * q.y() - p.y() * q.x();
}

// Appends the extreme points strictly between p and q, counter-clockwise.
void refine(const SupportFunction<2>& support, const Vector<2>& p, const Vector<2>& q, double tolerance,
            Points& points) {
    const Vector<2> chord = q - p;
    const double length = chord.norm();
    if (!(length > tolerance) || points.size() >= MaxVertices) return;
    const Vector<2> normal(chord.y() / length, -chord.x() / length);
    const Vector<2> extreme = support(normal, tolerance / 4, NodesPerEdge).point;
    if (!(normal.dot(extreme - p) > tolerance)) return;
    refine(support, p, extreme, tolerance, points);
    points.push_back(extreme);
    refine(support, extreme, q, tolerance, points);
}

// The hull of finitely many points, without those within `flatness` of a chord that can do without them.
Points hullOf(Points points, double flatness) {
    std::ranges::sort(points, [](const Vector<2>& p, const Vector<2>& q) {
        return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y();
    });
    const auto chain = [flatness](const auto& sorted) {
        Points result;
        for (const auto& p : sorted) {
            while (result.size() >= 2) {
                const Vector<2>& before = result[result.size() - 2];
                if (cross(result.back() - before, p - before) > flatness * (p - before).norm()) break;
                result.pop_back();
            }
            if (result.empty() || (p - result.back()).norm() > flatness) result.push_back(p);
        }
        return result;
    };
    Points lower = chain(points);
    std::ranges::reverse(points);
    const Points upper = chain(points);
    if (lower.size() < 2) return lower;
    lower.pop_back();
    lower.insert(lower.end(), upper.begin(), upper.end());
    lower.pop_back();
    return lower;
}

double distanceToSegment(const Vector<2>& x, const Vector<2>& p, const Vector<2>& q) {
    const Vector<2> chord = q - p;
    const double squared = chord.squaredNorm();
    const double t = squared > 0 ? std::clamp((x - p).dot(chord) / squared, 0.0, 1.0) : 0;
    return (x - p - t * chord).norm();
}

double distanceTo(const Points& polygon, const Vector<2>& x) {
    double distance = std::numeric_limits<double>::infinity();
    bool inside = polygon.size() >= 3;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vector<2>& p = polygon[k];
        const Vector<2>& q = polygon[(k + 1) % polygon.size()];
        if (cross(q - p, x - p) >= 0 && inside) continue;
        inside = false;
        distance = std::min(distance, distanceToSegment(x, p, q));
    }
    return inside ? 0 : distance;
}

// How far the images of the vertices leave the polygon.
double escape(const Points& polygon, const std::vector<AffineMap<2>>& maps) {
    double result = 0;
    for (const auto& map : maps)
        for (const auto& vertex : polygon)
            result = std::max(result, distanceTo(polygon, map(vertex)));
    return result;
}

double areaOf(const Points& polygon) {
    double twice = 0;
    for (std::size_t k = 2; k < polygon.size(); ++k)
        twice += cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
    return twice / 2;
}

} // namespace

ConvexHull convexHull(const SupportFunction<2>& support, double tolerance) {
    const double flatness = 1e-14 * (support.radius() + support.centre().norm());
    const double allowed = std::max(tolerance, 4 * flatness);
    const Vector<2> axes[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    Points corners;
    for (const auto& axis : axes)
        corners.push_back(support(axis, allowed / 4, NodesPerEdge).point);
    Points points;
    for (std::size_t k = 0; k < 4; ++k) {
        points.push_back(corners[k]);
        refine(support, corners[k], corners[(k + 1) % 4], allowed, points);
    }
    ConvexHull hull;
    hull.vertices = hullOf(std::move(points), flatness);
    hull.area = areaOf(hull.vertices);
    // W(P + rB) ⊂ P + rB for r = e/(1 − γ), in the norm in which the maps contract.
    hull.error =
        support.normEquivalence() * escape(hull.vertices, support.maps()) / (1 - support.contractivity()) +
        support.roundingError(64);
    return hull;
}

} // namespace ifs
