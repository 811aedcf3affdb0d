// SPDX-License-Identifier: MIT
#include "ifs/polygon.h"
#include "ifs/sandwich.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ifs {

namespace {

constexpr int MostLines = 2'000;

// How far the images of the vertices leave the polygon.
double escape(const Polygon& polygon, const std::vector<AffineMap<2>>& maps) {
    double result = 0;
    for (const auto& map : maps)
        for (const auto& vertex : polygon)
            result = std::max(result, distanceToConvex(polygon, map(vertex)));
    return result;
}

// Vertices accumulate at fixed points, whose neighbours no tolerance resolves; but they are known themselves.
void addFixedPoints(Polygon& points, const std::vector<AffineMap<2>>& maps, const Vector<2>& centre) {
    constexpr double WellKnown = 0.9; // of slower maps rounding moves them
    for (const auto& map : maps)
        if (const auto fixed = fixedPoint(map); fixed && spectralNorm<2>(map.linear) <= WellKnown)
            points.push_back(*fixed - centre);
}

} // namespace

ConvexHull convexHull(const SupportFunction<2>& support, double tolerance) {
    const double flatness = 1e-14 * (support.radius() + support.centre().norm());
    Sandwich sandwich(support, std::max(tolerance, 8e-12 * support.radius() + 4 * flatness),
                      support.outline(), MostLines);
    sandwich.settleCorners(convexHull(sandwich.outline().points(), flatness));
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
    hull.error = std::min(sandwich.error() + flatness, invariant);
    return hull;
}

} // namespace ifs
