// SPDX-License-Identifier: MIT
#include "ifs/support_function.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace ifs {

namespace {

using Points = std::vector<Vector<2>>;

constexpr std::size_t MaxVertices = 1'000;
constexpr int NodesPerEdge = 20'000;

double cross(const Vector<2>& p, const Vector<2>& q) {
    return p.x() * q.y() - p.y() * q.x();
}

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
Points extremePoints(const SupportFunction<2>& support, double tolerance) {
    Points points;
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

// The chains begin and end at the leftmost and rightmost points, which rounding may have picked inside an
// edge.
void dropSuperfluous(Points& polygon, double flatness) {
    for (std::size_t k = 0; k < polygon.size() && polygon.size() > 2;) {
        const Vector<2>& before = polygon[(k + polygon.size() - 1) % polygon.size()];
        const Vector<2> chord = polygon[(k + 1) % polygon.size()] - before;
        if (cross(polygon[k] - before, chord) > flatness * chord.norm())
            ++k;
        else
            polygon.erase(polygon.begin() + std::ptrdiff_t(k));
    }
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
    dropSuperfluous(lower, flatness);
    return lower;
}

double distanceToSegment(const Vector<2>& x, const Vector<2>& p, const Vector<2>& q) {
    const Vector<2> chord = q - p;
    const double squared = chord.squaredNorm();
    const double t = squared > 0 ? std::clamp((x - p).dot(chord) / squared, 0.0, 1.0) : 0;
    return (x - p - t * chord).norm();
}

// By bisection over the fan of triangles at the first vertex.
bool contains(const Points& polygon, const Vector<2>& x) {
    if (polygon.size() < 3) return false;
    const auto leftOf = [&x](const Vector<2>& p, const Vector<2>& q) { return cross(q - p, x - p) >= 0; };
    if (!leftOf(polygon.front(), polygon[1]) || !leftOf(polygon.back(), polygon.front())) return false;
    std::size_t low = 1, high = polygon.size() - 1;
    while (high - low > 1) {
        const std::size_t middle = (low + high) / 2;
        (leftOf(polygon.front(), polygon[middle]) ? low : high) = middle;
    }
    return leftOf(polygon[low], polygon[high]);
}

double distanceTo(const Points& polygon, const Vector<2>& x) {
    if (contains(polygon, x)) return 0;
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < polygon.size(); ++k)
        distance = std::min(distance, distanceToSegment(x, polygon[k], polygon[(k + 1) % polygon.size()]));
    return distance;
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
    ConvexHull hull;
    hull.vertices = hullOf(extremePoints(support, allowed), flatness);
    hull.area = areaOf(hull.vertices);
    // W(P + rB) ⊂ P + rB for r = e/(1 − γ), in the norm in which the maps contract.
    hull.error =
        support.normEquivalence() * escape(hull.vertices, support.maps()) / (1 - support.contractivity()) +
        support.roundingError(64);
    return hull;
}

} // namespace ifs
