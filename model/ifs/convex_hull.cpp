// SPDX-License-Identifier: MIT
#include "ifs/outline.h"
#include "ifs/polygon.h"
#include "ifs/support_function.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace ifs {

namespace {

constexpr std::size_t MostLines = 2'000;
constexpr int NodesPerLine = 4'000;

// The attractor from inside and outside at once, refined where the two are farthest apart: between two lines
// its hull lies between the corner where they meet and the segment of their points. Seen from the centre of
// the attractor.
class Sandwich {
public:
    Sandwich(const SupportFunction<2>& support, double tolerance)
        : m_support(support), m_tolerance(tolerance) {
        const Vector<2> axes[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
        for (const Vector<2>& axis : axes)
            add(axis, support(axis, tolerance / 8, NodesPerLine));
        while (m_outline.lines().size() < MostLines)
            if (!refine()) break;
    }

    const Polygon& points() const { return m_outline.points(); }

    // How far the attractor may lie outside the hull of the points.
    double error() const {
        double widest = 0;
        for (const auto& line : m_outline.lines())
            widest = std::max(widest, line.gap);
        return widest;
    }

    // In the middle of its normals a corner is alone the farthest: it is found exactly there, where the
    // search along an edge may stop anywhere beside it.
    void settleCorners(const Polygon& polygon) {
        const std::size_t n = polygon.size();
        for (std::size_t k = 0; n == 2 && k < n; ++k) // the ends of a segment
            settle((polygon[k] - polygon[1 - k]).normalized());
        constexpr std::size_t Round = 256; // corners of a curve, which only the tolerance makes
        for (std::size_t k = 0; n > 2 && n < Round && k < n; ++k) {
            const Vector<2> before = (polygon[k] - polygon[(k + n - 1) % n]).normalized(),
                            after = (polygon[(k + 1) % n] - polygon[k]).normalized();
            constexpr double LeastTurn = 1e-4; // less is a point that the tolerance left inside an edge
            if (cross(before, after) < LeastTurn && before.dot(after) > 0) continue;
            const Vector<2> along = before + after;
            if (along.norm() < 1e-6) continue;
            settle(Vector<2>(along.y(), -along.x()).normalized());
        }
    }

private:
    void settle(const Vector<2>& outward) { add(outward, m_support(outward, 0, NodesPerLine, &m_outline)); }

    void add(const Vector<2>& normal, const SupportValue<2>& h) {
        const Vector<2>& centre = m_support.centre();
        m_outline.add(normal, h.value + h.error - normal.dot(centre), h.point - centre,
                      h.error <= m_tolerance / 2);
    }

    const Vector<2>& pointAt(std::size_t line) const {
        return m_outline.points()[m_outline.lines()[line % m_outline.lines().size()].point];
    }

    // Asks once more where it is worth most; false when nowhere.
    bool refine() {
        double widest = m_tolerance;
        std::optional<Vector<2>> best;
        for (std::size_t k = 0; k < m_outline.lines().size(); ++k)
            if (const double gap = m_outline.lines()[k].gap; gap > widest)
                if (const auto normal = directionInto(k)) {
                    widest = gap;
                    best = normal;
                }
        if (best) add(*best, m_support(*best, m_tolerance / 32, NodesPerLine, &m_outline));
        return best.has_value();
    }

    // Along the chord where it is longer than the gap is wide, else between the two normals. nullopt when no
    // direction between them can tell more.
    std::optional<Vector<2>> directionInto(std::size_t line) const {
        const Outline::Line &a = m_outline.lines()[line],
                            &b = m_outline.lines()[(line + 1) % m_outline.lines().size()];
        const double turn = cross(a.normal, b.normal);
        constexpr double LeastTurn = 1e-10;
        if (!a.settled || !b.settled || turn < 2 * LeastTurn) return std::nullopt;
        const Vector<2> chord = pointAt(line + 1) - pointAt(line);
        if (chord.norm() > a.gap) {
            const Vector<2> normal = Vector<2>(chord.y(), -chord.x()).normalized();
            if (cross(a.normal, normal) > turn / 64 && cross(normal, b.normal) > turn / 64) return normal;
        }
        return (a.normal + b.normal).normalized();
    }

    const SupportFunction<2>& m_support;
    double m_tolerance;
    Outline m_outline;
};

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
    Sandwich sandwich(support, std::max(tolerance, 8e-12 * support.radius() + 4 * flatness));
    sandwich.settleCorners(convexHull(sandwich.points(), flatness));
    ConvexHull hull;
    Polygon points = sandwich.points();
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
