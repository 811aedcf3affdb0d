// SPDX-License-Identifier: MIT
#include "ifs/polygon.h"

#include <algorithm>
#include <limits>

namespace ifs {

namespace {

// The chains begin and end at the leftmost and rightmost points, which rounding may have picked inside an
// edge.
void dropSuperfluous(Polygon& polygon, double flatness) {
    for (std::size_t k = 0; k < polygon.size() && polygon.size() > 2;) {
        const Vector<2>& before = polygon[(k + polygon.size() - 1) % polygon.size()];
        const Vector<2> chord = polygon[(k + 1) % polygon.size()] - before;
        if (cross(polygon[k] - before, chord) > flatness * chord.norm())
            ++k;
        else
            polygon.erase(polygon.begin() + std::ptrdiff_t(k));
    }
}

double distanceToSegment(const Vector<2>& x, const Vector<2>& p, const Vector<2>& q) {
    const Vector<2> chord = q - p;
    const double squared = chord.squaredNorm();
    const double t = squared > 0 ? std::clamp((x - p).dot(chord) / squared, 0.0, 1.0) : 0;
    return (x - p - t * chord).norm();
}

// By bisection over the fan of triangles at the first vertex.
bool contains(const Polygon& polygon, const Vector<2>& x) {
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

} // namespace

Polygon convexHull(std::vector<Vector<2>> points, double flatness) {
    std::ranges::sort(points, [](const Vector<2>& p, const Vector<2>& q) {
        return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y();
    });
    const auto chain = [flatness](const auto& sorted) {
        Polygon result;
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
    Polygon lower = chain(points);
    std::ranges::reverse(points);
    const Polygon upper = chain(points);
    if (lower.size() < 2) return lower;
    lower.pop_back();
    lower.insert(lower.end(), upper.begin(), upper.end());
    lower.pop_back();
    dropSuperfluous(lower, flatness);
    return lower;
}

double area(const Polygon& polygon) {
    double twice = 0;
    for (std::size_t k = 2; k < polygon.size(); ++k)
        twice += cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
    return twice / 2;
}

double distanceToConvex(const Polygon& polygon, const Vector<2>& x) {
    if (contains(polygon, x)) return 0;
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < polygon.size(); ++k)
        distance = std::min(distance, distanceToSegment(x, polygon[k], polygon[(k + 1) % polygon.size()]));
    return distance;
}

} // namespace ifs
