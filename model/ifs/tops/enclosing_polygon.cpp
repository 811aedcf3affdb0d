// SPDX-License-Identifier: MIT
#include "ifs/tops/enclosing_polygon.h"

#include "ifs/extent/polygon.h"

#include <algorithm>
#include <cmath>

namespace ifs {

namespace {

constexpr double looseness = 1e-9;  // radii; error of the support values
constexpr double roundness = 1e-13; // exceeds the rounding of their hull
constexpr std::size_t sides = EnclosingPolygon::sides;

double farthestApart(const EnclosingPolygon::Corners& a, const EnclosingPolygon::Corners& b) {
    double square = 0;
    for (const Vector<2>& p : a)
        for (const Vector<2>& q : b)
            square = std::max(square, (p - q).squaredNorm());
    return std::sqrt(square);
}

} // namespace

const std::array<Vector<2>, sides>& EnclosingPolygon::directions() {
    static const std::array<Vector<2>, sides> all = [] {
        const double half = std::sqrt(0.5);
        const double c = std::sqrt(2 + std::sqrt(2.0)) / 2, s = std::sqrt(2 - std::sqrt(2.0)) / 2;
        std::array<Vector<2>, sides> result{Vector<2>(1, 0), Vector<2>(c, s), Vector<2>(half, half),
                                            Vector<2>(s, c)};
        for (std::size_t k = 4; k < sides; ++k) // quarter turns of the first directions
            result[k] = {-result[k - 4].y(), result[k - 4].x()};
        return result;
    }();
    return all;
}

EnclosingPolygon::EnclosingPolygon(const SupportFunction<2>& attractor) {
    const auto& normals = directions();
    for (std::size_t k = 0; k < sides; ++k) {
        const SupportValue<2> value = attractor(normals[k], looseness * attractor.radius());
        heights[k] = value.value + value.error + roundness * attractor.radius();
    }
    Polygon meetings(sides); // intersections of adjacent lines, unordered if other lines cut them off
    for (std::size_t k = 0; k < sides; ++k) {
        const std::size_t next = (k + 1) % sides;
        const Vector<2>&u = normals[k], &v = normals[next];
        meetings[k] = Vector<2>(heights[k] * v.y() - heights[next] * u.y(),
                                heights[next] * u.x() - heights[k] * v.x()) /
                      cross(u, v);
    }
    const Polygon hull = convexHull(std::move(meetings), 0);
    corners.fill(hull.back());
    std::ranges::copy(hull, corners.begin());
}

EnclosingPolygon::Corners EnclosingPolygon::image(const AffineMap<2>& map) const {
    Corners result;
    std::ranges::transform(corners, result.begin(), [&](const Vector<2>& corner) { return map(corner); });
    return result;
}

EnclosingPolygon::Heights heightsOf(const EnclosingPolygon::Corners& corners) {
    const auto& normals = EnclosingPolygon::directions();
    EnclosingPolygon::Heights result;
    for (std::size_t k = 0; k < sides; ++k) {
        result[k] = normals[k].dot(corners.front());
        for (const Vector<2>& corner : corners)
            result[k] = std::max(result[k], normals[k].dot(corner));
    }
    return result;
}

double diameterOf(const EnclosingPolygon::Corners& corners) {
    return farthestApart(corners, corners);
}

double diameterOf(const EnclosingPolygon::Corners& a, const EnclosingPolygon::Corners& b) {
    return std::max({farthestApart(a, a), farthestApart(b, b), farthestApart(a, b)});
}

} // namespace ifs
