// SPDX-License-Identifier: MIT
#include "ifs/extent/polygon.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace ifs {

namespace {

// Returns true if r lies to the left of the line from p to q, exactly. Where rounding leaves it open, the
// twelve parts of p×q + q×r + r×p are summed without a rest (Shewchuk, Adaptive precision floating-point
// arithmetic, 1997).
bool isLeft(const Vector<2>& r, const Vector<2>& p, const Vector<2>& q) {
    const double left = (q.x() - p.x()) * (r.y() - p.y()), right = (q.y() - p.y()) * (r.x() - p.x());
    const double terms = std::abs(left) + std::abs(right);
    if (std::abs(left - right) > 0x1p-51 * terms && terms > 0x1p-900) return left > right;
    constexpr double tiny = 0x1p-400, longer = 0x1p+300; // limits within which products do not underflow
    const double size = r.cwiseAbs().cwiseMax(p.cwiseAbs()).cwiseMax(q.cwiseAbs()).maxCoeff();
    if (size > 0 && size < tiny) return isLeft(longer * r, longer * p, longer * q);
    std::array<double, 12> parts{}; // non-overlapping parts of the sum
    std::size_t count = 0;
    const auto add = [&](double term) {
        for (double& part : std::span(parts).first(count)) {
            const double sum = part + term, added = sum - part;
            part = (part - (sum - added)) + (term - added);
            term = sum;
        }
        parts[count++] = term;
    };
    const auto addProduct = [&](double a, double b) {
        const double product = a * b;
        add(std::fma(a, b, -product));
        add(product);
    };
    for (const auto& [a, b] : {std::pair(&p, &q), {&q, &r}, {&r, &p}}) {
        addProduct(a->x(), b->y());
        addProduct(-a->y(), b->x());
    }
    const auto leading = std::find_if(parts.rbegin(), parts.rend(), [](double part) { return part != 0; });
    return leading != parts.rend() && *leading > 0;
}

// The polygon of the longest chords, from corner to corner, that pass no corner between at more than
// `flatness`.
Polygon thinned(const Polygon& hull, double flatness) {
    const std::size_t n = hull.size();
    const auto corner = [&](std::size_t k) { return hull[k < n ? k : k - n]; };
    const auto isFlat = [&](std::size_t from, std::size_t to) {
        for (std::size_t k = from + 1; k < to; ++k)
            if (distanceToSegment(corner(k), corner(from), corner(to)) > flatness) return false;
        return true;
    };
    std::vector<std::size_t> kept;
    for (std::size_t k = 0; k < n;) {
        kept.push_back(k++);
        while (k < n && isFlat(kept.back(), k + 1))
            ++k;
    }
    // The first vertex lay inside an edge.
    if (kept.size() > 2 && isFlat(kept.back(), kept[1] + n)) kept.erase(kept.begin());
    Polygon result;
    for (const std::size_t k : kept)
        result.push_back(hull[k]);
    return result;
}

// Bisects the fan of triangles at the first vertex.
bool contains(const Polygon& polygon, const Vector<2>& x) {
    if (polygon.size() < 3) return false;
    const auto leftOf = [&x](const Vector<2>& p, const Vector<2>& q) { return !isLeft(x, q, p); };
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
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 2) return points;
    const auto chain = [](const auto& sorted) {
        Polygon result;
        for (const auto& p : sorted) {
            while (result.size() >= 2 && !isLeft(p, result[result.size() - 2], result.back()))
                result.pop_back();
            result.push_back(p);
        }
        result.pop_back(); // first point of the other chain
        return result;
    };
    Polygon hull = chain(points);
    std::ranges::reverse(points);
    const Polygon upper = chain(points);
    hull.insert(hull.end(), upper.begin(), upper.end());
    return thinned(hull, flatness);
}

double distanceToSegment(const Vector<2>& x, const Vector<2>& p, const Vector<2>& q) {
    const Vector<2> chord = q - p;
    const double squared = chord.squaredNorm();
    const double t = squared > 0 ? std::clamp((x - p).dot(chord) / squared, 0.0, 1.0) : 0;
    const Vector<2> rest = x - p - t * chord;
    const double distance = rest.norm();
    return distance > 0x1p-500 ? distance : rest.stableNorm(); // stable norm, since squares underflow
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
