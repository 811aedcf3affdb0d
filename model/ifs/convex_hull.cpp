// SPDX-License-Identifier: MIT
#include "ifs/support_function.h"

#include "ifs/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace ifs {

namespace {

constexpr std::size_t MaxVertices = 1'000;
constexpr int NodesPerEdge = 20'000;

// Two points of the hull, counter-clockwise, and the extreme point outside the line through them.
struct Chord {
    Vector<2> from, to, extreme;
    double gap = 0; // how far out the extreme point lies

    bool operator<(const Chord& other) const { return gap < other.gap; }
};

Chord chordOf(const SupportFunction<2>& support, const Vector<2>& from, const Vector<2>& to,
              double tolerance) {
    const Vector<2> along = to - from;
    const double length = along.norm();
    if (!(length > tolerance)) return {from, to, from, 0};
    const Vector<2> normal(along.y() / length, -along.x() / length);
    // As exactly as possible: what misses the maximum by a little may lie far to the side.
    const Vector<2> extreme = support(normal, 0, NodesPerEdge).point;
    const bool isNew = (extreme - from).norm() > tolerance && (extreme - to).norm() > tolerance;
    return {from, to, extreme, isNew ? normal.dot(extreme - from) : 0};
}

// Breaks the chord with the widest gap first, so that a limit on the vertices leaves an even approximation.
Polygon extremePoints(const SupportFunction<2>& support, double tolerance) {
    Polygon points;
    for (const Vector<2>& axis : {Vector<2>(1, 0), Vector<2>(0, 1), Vector<2>(-1, 0), Vector<2>(0, -1)})
        points.push_back(support(axis, 0, NodesPerEdge).point);
    std::priority_queue<Chord> chords;
    for (std::size_t k = 0; k < 4; ++k)
        chords.push(chordOf(support, points[k], points[(k + 1) % 4], tolerance));
    while (!chords.empty() && chords.top().gap > tolerance && points.size() < MaxVertices) {
        const Chord widest = chords.top();
        chords.pop();
        points.push_back(widest.extreme);
        chords.push(chordOf(support, widest.from, widest.extreme, tolerance));
        chords.push(chordOf(support, widest.extreme, widest.to, tolerance));
    }
    return points;
}

// How far the images of the vertices leave the polygon.
double escape(const Polygon& polygon, const std::vector<AffineMap<2>>& maps) {
    double result = 0;
    for (const auto& map : maps)
        for (const auto& vertex : polygon)
            result = std::max(result, distanceToConvex(polygon, map(vertex)));
    return result;
}

} // namespace

ConvexHull convexHull(const SupportFunction<2>& support, double tolerance) {
    const double flatness = 1e-14 * (support.radius() + support.centre().norm());
    const double allowed = std::max(tolerance, 4 * flatness);
    ConvexHull hull;
    hull.vertices = convexHull(extremePoints(support, allowed), flatness);
    hull.area = area(hull.vertices);
    // W(P + rB) ⊂ P + rB for r = e/(1 − γ), in the norm in which the maps contract.
    hull.error =
        support.normEquivalence() * escape(hull.vertices, support.maps()) / (1 - support.contractivity()) +
        support.roundingError(64);
    return hull;
}

} // namespace ifs
