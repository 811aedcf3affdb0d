// SPDX-License-Identifier: MIT
#include "ifs/extent/convex_hull.h"

#include "ifs/extent/polygon.h"
#include "ifs/extent/sandwich.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>

namespace ifs {

namespace {

constexpr int maxLines = 2'000;

// Distance by which the images of the vertices leave the polygon.
double escape(const Polygon& polygon, const std::vector<AffineMap<2>>& maps) {
    double result = 0;
    for (const auto& map : maps)
        for (const auto& vertex : polygon)
            result = std::max(result, distanceToConvex(polygon, map(vertex)));
    return result;
}

// Vertices accumulate at fixed points, whose neighbours no tolerance resolves; but they are known themselves.
void addFixedPoints(Polygon& points, const std::vector<AffineMap<2>>& maps, const Vector<2>& centre) {
    constexpr double maxContractivity = 0.9; // limit beyond which rounding moves maps noticeably
    for (const auto& map : maps)
        if (const auto fixed = fixedPoint(map); fixed && spectralNorm<2>(map.linear) <= maxContractivity)
            points.push_back(*fixed - centre);
}

} // namespace

ConvexHull convexHull(const SupportFunction<2>& support, double tolerance) {
    return *convexHull(support, tolerance, {});
}

std::optional<ConvexHull> convexHull(const SupportFunction<2>& support, double tolerance,
                                     const std::stop_token& stop) {
    if (const auto* better = support.conditioning()) {
        const double stretch = spectralNorm<2>(better->image.linear);
        auto hull = convexHull(better->support, tolerance / stretch, stop);
        if (!hull) return std::nullopt;
        for (auto& vertex : hull->vertices)
            vertex = better->image(vertex);
        hull->area *= determinant<2>(better->image.linear);
        hull->error = better->errorOf(hull->error);
        return hull;
    }
    const double flatness = 1e-14 * (support.radius() + support.centre().norm());
    Sandwich sandwich(std::cref(support), support.centre(),
                      std::max(tolerance, 8e-12 * support.radius() + 4 * flatness), support.outline(stop),
                      maxLines, stop);
    sandwich.settleCorners(convexHull(sandwich.outline().points(), flatness));
    if (stop.stop_requested()) return std::nullopt;
    ConvexHull hull;
    Polygon points = sandwich.outline().points();
    addFixedPoints(points, support.maps(), support.centre());
    hull.vertices = convexHull(std::move(points), flatness);
    for (auto& vertex : hull.vertices)
        vertex += support.centre();
    hull.area = area(hull.vertices);
    // W(P + rB) ⊂ P + rB for r = e/(1 − γ), in the norm in which the maps contract.
    const double invariant =
        support.normEquivalence() * escape(hull.vertices, support.maps()) / (1 - support.contractivity()) +
        support.roundingError(64);
    const double lost = 2 * flatness; // loss from omitted corners and rounding
    hull.error = std::min(sandwich.error() + lost, invariant);
    return hull;
}

double areaError(const ConvexHull& hull) {
    double perimeter = 0;
    for (std::size_t k = 0; k < hull.vertices.size(); ++k)
        perimeter += (hull.vertices[(k + 1) % hull.vertices.size()] - hull.vertices[k]).norm();
    const double error = (perimeter + std::numbers::pi * hull.error) * hull.error * (1 + 1e-12);
    return hull.error > 0 ? std::max(error, std::numeric_limits<double>::denorm_min()) : 0;
}

} // namespace ifs
