// SPDX-License-Identifier: MIT
#include "ifs/cage/hull_cage.h"

#include "ifs/extent/convex_hull.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ifs {

namespace {

// The prolongations of ab and dc beyond the edge bc, and the area of the triangle that they cut off.
struct Ear {
    double area = std::numeric_limits<double>::infinity(); // infinite if they do not meet
    Vector<2> tip;
};

Ear earOver(const Polygon& polygon, std::size_t edge) {
    const std::size_t n = polygon.size();
    const Vector<2>& b = polygon[edge];
    const Vector<2>& c = polygon[(edge + 1) % n];
    const Vector<2> ab = b - polygon[(edge + n - 1) % n], cd = polygon[(edge + 2) % n] - c, bc = c - b;
    const double turn = cross(ab, cd);
    if (!(turn > 1e-12 * ab.norm() * cd.norm())) return {};
    const double beyond = std::max(0.0, cross(bc, cd) / turn);
    return {std::abs(beyond * cross(ab, bc)) / 2, b + beyond * ab};
}

// The triangle with a corner at a corner of the quadrilateral p q r s, two sides along pq and ps, and the
// third through r.
Polygon triangleAt(std::size_t corner, const Polygon& quadrilateral) {
    const Vector<2>& p = quadrilateral[corner];
    const Vector<2> q = quadrilateral[(corner + 1) % 4] - p, r = quadrilateral[(corner + 2) % 4] - p,
                    s = quadrilateral[(corner + 3) % 4] - p;
    const double stretch = (cross(r, s) + cross(q, r)) / cross(q, s);
    return {p, p + stretch * q, p + stretch * s};
}

// The smallest of those and of the triangles that two opposite sides make with a third.
Polygon triangleAround(const Polygon& quadrilateral) {
    Polygon smallest = triangleAt(0, quadrilateral);
    const auto offer = [&smallest](Polygon triangle) {
        if (area(triangle) < area(smallest)) smallest = std::move(triangle);
    };
    for (std::size_t k = 0; k < 4; ++k) {
        offer(triangleAt(k, quadrilateral));
        if (const Ear ear = earOver(quadrilateral, k); std::isfinite(ear.area))
            offer({quadrilateral[(k + 3) % 4], ear.tip, quadrilateral[(k + 2) % 4]});
    }
    return smallest;
}

// The minimizer of a convex function on [low, high].
template <class Function> double minimum(Function function, double low, double high) {
    constexpr int steps = 60;
    for (int n = 0; n < steps; ++n) {
        const double third = (high - low) / 3;
        function(low + third) < function(high - third) ? high -= third : low += third;
    }
    return (low + high) / 2;
}

} // namespace

Polygon enlargedHull(const Polygon& hull, double distance) {
    std::vector<Vector<2>> points;
    for (const auto& corner : hull)
        for (const double x : {-distance, distance})
            for (const double y : {-distance, distance})
                points.emplace_back(corner + Vector<2>(x, y));
    return convexHull(std::move(points), 0);
}

Polygon enlargedHull(const SupportFunction<2>& support) {
    const double fine = 1e-6 * support.radius();
    const ConvexHull hull = convexHull(support, fine);
    return enlargedHull(hull.vertices, hull.error + fine);
}

Polygon simplifiedHull(const Polygon& hull, int corners) {
    Polygon polygon = hull;
    std::vector<Ear> ears;
    for (std::size_t edge = 0; edge < polygon.size(); ++edge)
        ears.push_back(earOver(polygon, edge));
    const std::size_t wanted = std::size_t(std::max(corners, 4));
    while (polygon.size() > wanted) {
        const auto least = std::ranges::min_element(ears, {}, &Ear::area) - ears.begin();
        const Ear ear = ears[std::size_t(least)];
        const std::size_t after = (std::size_t(least) + 1) % polygon.size();
        polygon[std::size_t(least)] = ear.tip;
        polygon.erase(polygon.begin() + std::ptrdiff_t(after)); // removes the edge of the tip
        ears.erase(ears.begin() + std::ptrdiff_t(after));
        const std::size_t n = polygon.size(), tip = std::size_t(least) - (after == 0 ? 1 : 0);
        for (std::size_t edge = tip + n - 2; edge <= tip + n + 1; ++edge)
            ears[edge % n] = earOver(polygon, edge % n);
    }
    return corners == 3 && polygon.size() == 4 ? triangleAround(polygon) : polygon;
}

Polygon smallestRectangleAround(const Polygon& hull) {
    Polygon smallest;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < hull.size(); ++k) {
        const Vector<2> edge = hull[(k + 1) % hull.size()] - hull[k];
        if (!(edge.norm() > 0)) continue;
        const Vector<2> along = edge.normalized();
        const Vector<2> across(-along.y(), along.x());
        Vector<2> low(along.dot(hull[0]), across.dot(hull[0]));
        Vector<2> high = low;
        for (const auto& corner : hull) {
            const Vector<2> at(along.dot(corner), across.dot(corner));
            low = low.cwiseMin(at);
            high = high.cwiseMax(at);
        }
        const double size = (high - low).prod();
        if (!(size < least)) continue;
        least = size;
        const auto corner = [&](double u, double v) { return Vector<2>(u * along + v * across); };
        smallest = {corner(low.x(), low.y()), corner(high.x(), low.y()), corner(high.x(), high.y()),
                    corner(low.x(), high.y())};
    }
    return smallest;
}

Polygon regularPolygonAround(const Polygon& hull, int corners) {
    const double step = 2 * std::numbers::pi / corners;
    const auto direction = [step](double k) {
        const double angle = k * step - std::numbers::pi / 2; // 0 for the base
        return Vector<2>(std::cos(angle), std::sin(angle));
    };
    std::vector<std::pair<Vector<2>, double>> faces;
    for (int k = 0; k < corners; ++k) {
        const Vector<2> normal = direction(k);
        double height = -std::numeric_limits<double>::infinity();
        for (const auto& corner : hull)
            height = std::max(height, normal.dot(corner));
        faces.emplace_back(normal, height);
    }
    const auto apothem = [&faces](const Vector<2>& centre) {
        double reach = 0;
        for (const auto& [normal, height] : faces)
            reach = std::max(reach, height - normal.dot(centre));
        return reach;
    };
    Vector<2> min = hull.front(), max = hull.front();
    for (const auto& corner : hull) {
        min = min.cwiseMin(corner);
        max = max.cwiseMax(corner);
    }
    const auto bestY = [&](double x) {
        return minimum([&](double y) { return apothem({x, y}); }, min.y(), max.y());
    };
    const double x = minimum([&](double at) { return apothem({at, bestY(at)}); }, min.x(), max.x());
    const Vector<2> centre(x, bestY(x));
    const double reach = apothem(centre), size = centre.norm() + reach;
    const double radius = (reach > 1e-15 * size ? reach : 1) / std::cos(step / 2);
    Polygon polygon;
    for (int k = 0; k < corners; ++k)
        polygon.emplace_back(centre + radius * direction(k - 0.5));
    return polygon;
}

} // namespace ifs
