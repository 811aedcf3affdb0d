// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/extent/polygon.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>

using namespace ifs;
using namespace canonical;

namespace {

constexpr double rounding = 4e-15; // of points of size about 1

Vector<2> quarterTurned(const Vector<2>& x) {
    return Vector<2>(-x.y(), x.x());
}

// How far x is from a convex polygon, edge by edge.
double outside(const Polygon& polygon, const Vector<2>& x) {
    double nearest = infinity;
    bool isBeyond = polygon.size() < 3;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vector<2>&p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
        isBeyond |= cross(q - p, x - p) < 0;
        nearest = std::min(nearest, distanceToSegment(x, p, q));
    }
    return isBeyond ? nearest : 0;
}

double farthestOutside(const Polygon& polygon, const std::vector<Vector<2>>& points) {
    double farthest = 0;
    for (const auto& point : points)
        farthest = std::max(farthest, outside(polygon, point));
    return farthest;
}

// Runs of points along edges, upright or leaning, each a little off by rounding or by `noise`.
std::vector<Vector<2>> runs(Random& random, double noise) {
    const Vector<2> directions[] = {{0, 1}, {1, 0}, {0.6, 0.8}, {-0.8, 0.6}, {0x1p-52, 1}};
    std::vector<Vector<2>> points;
    for (int run = 1 + int(random() % 4); run > 0; --run) {
        const Vector<2> from = randomVector<2>(random), along = directions[random() % std::size(directions)];
        for (int n = 1 + int(random() % 40); n > 0; --n)
            points.push_back(from + uniform(random) * along + randomVector<2>(random, noise));
    }
    return points;
}

} // namespace

class PolygonTest : public QObject {
    Q_OBJECT

private slots:
    void squaresOfLengthsMayUnderflow() {
        for (const int exponent : {-300, -520, -600, -1000}) {
            const double unit = std::ldexp(1, exponent);
            const Polygon corners{{0, 0}, {unit, 0}, {unit, unit}, {0, unit}};
            std::vector<Vector<2>> points = corners;
            points.push_back(Vector<2>(unit, unit) / 2);
            QCOMPARE(convexHull(points, 1e-14 * unit), corners);
            QCOMPARE(distanceToConvex(corners, {3 * unit, unit / 2}), 2 * unit);
            QCOMPARE(distanceToConvex(corners, {unit / 2, unit / 2}), 0.0);
        }
    }

    // The topmost of three points above each other is the second from the left.
    void rightmostIsNotHighest() {
        const Polygon hull = convexHull({{0, 0}, {1, 0}, {1 + 0x1p-52, 1}, {1 + 0x1p-51, 0.5}}, 1e-14);
        QCOMPARE(hull, (Polygon{{0, 0}, {1, 0}, {1 + 0x1p-52, 1}}));
    }

    void nothingDroppedLiesFartherOut() {
        Random random(1);
        for (int n = 0; n < 4000; ++n) {
            const double noise = std::pow(10, uniform(random, -18, -12)),
                         flatness = n % 4 == 0 ? 0 : std::pow(10, uniform(random, -16, -2));
            auto points = runs(random, noise);
            for (int turn = 0; turn < 4; ++turn) {
                const Polygon hull = convexHull(points, flatness);
                const double lost = farthestOutside(hull, points);
                QVERIFY2(lost <= flatness + rounding,
                         qPrintable(QStringLiteral("%1 > %2").arg(lost).arg(flatness)));
                for (const auto& corner : hull)
                    QVERIFY(std::ranges::find(points, corner) != points.end());
                std::ranges::transform(points, points.begin(), quarterTurned);
            }
        }
    }

    // Of a fine chain along a circle no more stay than the flatness needs.
    void whatIsFlatIsDropped() {
        std::vector<Vector<2>> circle;
        for (int k = 0; k < 3000; ++k)
            circle.emplace_back(std::cos(k * 2 * std::numbers::pi / 3000),
                                std::sin(k * 2 * std::numbers::pi / 3000));
        const Polygon hull = convexHull(circle, 1e-4);
        QCOMPARE(hull.size(), std::size_t(231)); // 13 steps to a chord: 1 − cos(13π/3000) ≤ 10⁻⁴ < that of 14
        QVERIFY(farthestOutside(hull, circle) <= 1e-4);
    }

    // However rounding scatters points along the sides of a square, it has four corners.
    void sidesHaveNoCorners() {
        Random random(2);
        for (int n = 0; n < 200; ++n) {
            std::vector<Vector<2>> points;
            for (Vector<2> corner : {Vector<2>(1, 1), {-1, 1}, {-1, -1}, {1, -1}}) {
                points.push_back(corner);
                const Vector<2> side = quarterTurned(corner) - corner;
                for (int k = 0; k < 50; ++k)
                    points.push_back(corner + uniform(random, 0.01, 0.99) * side +
                                     randomVector<2>(random, 1e-16));
            }
            QCOMPARE(convexHull(points, 1e-14).size(), std::size_t(4));
        }
    }

    void pointsAndSegments() {
        QVERIFY(convexHull({}, 0).empty());
        QCOMPARE(convexHull({{1, 2}, {1, 2}}, 0), (Polygon{{1, 2}}));
        QCOMPARE(convexHull({{1, 2}, {1, 2 + 1e-15}, {1 + 1e-15, 2}}, 1e-14).size(), std::size_t(1));
        const Polygon upright = convexHull({{0, 0.5}, {1e-16, 1}, {2e-16, 0}, {2e-16, 0.25}}, 1e-14);
        QCOMPARE(upright.size(), std::size_t(2));
        QCOMPARE(std::abs(upright[0].y() - upright[1].y()), 1.0);
    }
};

BARYCAGE_TEST(PolygonTest);
#include "polygon_test.moc"
