// SPDX-License-Identifier: MIT
#include "ifs/cage/hull_cage.h"
#include "ifs/canonical_systems.h"
#include "ifs/extent/convex_hull.h"
#include "ifs/extent/extent.h"
#include "support/named_test.h"

#include <QtTest>

#include <numbers>

using namespace ifs;
using namespace canonical;

namespace {

Polygon cageOf(const Maps2& maps, int corners) {
    const auto hull = convexHull(*SupportFunction<2>::of(maps), 1e-6);
    return simplifiedHull(enlargedHull(hull.vertices, hull.error), corners);
}

// How far x lies outside the half planes of the edges, walked counter-clockwise.
double outside(const Polygon& polygon, const Vector<2>& x) {
    double farthest = -infinity;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vector<2> edge = polygon[(k + 1) % polygon.size()] - polygon[k];
        farthest = std::max(farthest, cross(x - polygon[k], edge) / edge.norm());
    }
    return farthest;
}

bool isStrictlyConvex(const Polygon& polygon) {
    const std::size_t n = polygon.size();
    for (std::size_t k = 0; k < n; ++k)
        if (!(cross(polygon[(k + 1) % n] - polygon[k], polygon[(k + 2) % n] - polygon[(k + 1) % n]) > 0))
            return false;
    return n >= 3;
}

void areas(const Maps2& maps, std::initializer_list<std::pair<int, double>> expected) {
    for (const auto& [corners, size] : expected) {
        const Polygon cage = cageOf(maps, corners);
        QCOMPARE(cage.size(), std::size_t(corners));
        QVERIFY2(std::abs(area(cage) - size) < 1e-3, qPrintable(QString::number(area(cage), 'g', 9)));
    }
}

} // namespace

class HullCageTest : public QObject {
    Q_OBJECT

private slots:
    void areasOfMapleAndFlower() {
        areas(maple(), {{12, 35.821}, {8, 36.204}, {6, 36.804}, {4, 40.196}});
        areas(flower(), {{8, 6.774}, {4, 8.011}});
    }

    void eightCornersOfMaple() {
        const Polygon cage = cageOf(maple(), 8);
        for (const Vector<2>& expected : {Vector<2>(3.2322, 1.7858),
                                          {2.0249, 4.0697},
                                          {0.9817, 5.0726},
                                          {-1.1981, 5.0722},
                                          {-2.9884, 2.7584},
                                          {-3.3999, 1.3168},
                                          {-0.1149, -3.1731},
                                          {3.3939, -0.1408}})
            QVERIFY(std::ranges::any_of(
                cage, [&](const Vector<2>& corner) { return (corner - expected).norm() < 2e-4; }));
    }

    // A square on its corner, and a hull whose least rectangle is known.
    void theSmallestRectangleTurns() {
        const Polygon diamond{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
        QVERIFY(std::abs(area(smallestRectangleAround(diamond)) - 2) < 1e-12);
        const Polygon triangle{{0, 0}, {3, 0}, {0, 4}}; // 12 along a leg and along the hypotenuse alike
        QVERIFY(std::abs(area(smallestRectangleAround(triangle)) - 12) < 1e-12);
        Random random(7);
        for (int n = 0; n < 100; ++n) {
            const auto maps = randomContractions<2>(random, 1 + int(random() % 4));
            const Polygon hull = enlargedHull(*SupportFunction<2>::of(maps));
            const Polygon rectangle = smallestRectangleAround(hull);
            QCOMPARE(rectangle.size(), std::size_t{4});
            double size = 0;
            double least = infinity;
            for (const auto& corner : hull) {
                size = std::max(size, corner.norm());
                QVERIFY(outside(rectangle, corner) < 1e-12 * (1 + size));
            }
            // None of a thousand directions does better.
            for (int k = 0; k < 1000; ++k) {
                const Vector<2> along(std::cos(k * std::numbers::pi / 2000),
                                      std::sin(k * std::numbers::pi / 2000));
                Vector<2> low(infinity, infinity);
                Vector<2> high = -low;
                for (const auto& corner : hull) {
                    const Vector<2> at(along.dot(corner), cross(along, corner));
                    low = low.cwiseMin(at);
                    high = high.cwiseMax(at);
                }
                least = std::min(least, (high - low).prod());
            }
            QVERIFY(area(rectangle) <= least * (1 + 1e-9));
        }
    }

    void containsTheOrbit() {
        Random random(1);
        for (int n = 0; n < 100; ++n) {
            const auto maps = randomContractions<2>(random, 1 + int(random() % 4));
            const auto support = *SupportFunction<2>::of(maps);
            const auto hull = convexHull(support, 1e-5 * support.radius());
            const double size = support.centre().norm() + support.radius();
            const Polygon around = enlargedHull(hull.vertices, std::max(hull.error, 1e-9 * size));
            for (const int corners : {3, 4, 5, 8, 64}) {
                const Polygon cage = simplifiedHull(around, corners);
                const Polygon regular = regularPolygonAround(hull.vertices, corners);
                QVERIFY(cage.size() <= std::size_t(corners) && isStrictlyConvex(cage));
                QVERIFY(corners > 4 || area(cage) <= 2.1 * area(around));
                QVERIFY(regular.size() == std::size_t(corners) && isStrictlyConvex(regular));
                for (const auto& x : orbit<2>(maps, 100, random)) {
                    QVERIFY(outside(cage, x) <= 1e-13 * size);
                    QVERIFY(outside(regular, x) <= hull.error + 1e-13 * size);
                }
            }
        }
    }

    // The smallest triangle around a parallelogram has twice its area.
    void parallelogramsBecomeTriangles() {
        Random random(2);
        for (int n = 0; n < 100; ++n) {
            const Vector<2> at = randomVector<2>(random, 5), p = randomVector<2>(random),
                            q = randomVector<2>(random) + Vector<2>(-p.y(), p.x());
            if (cross(p, q) < 0.1) continue;
            Polygon quadrilateral{at, at + p, at + p + q, at + q};
            QCOMPARE(simplifiedHull(quadrilateral, 4), quadrilateral);
            quadrilateral[2] += randomVector<2>(random, n % 2 == 0 ? 0 : 1e-7);
            const Polygon triangle = simplifiedHull(quadrilateral, 3);
            QCOMPARE(triangle.size(), std::size_t(3));
            QVERIFY(std::abs(area(triangle) - 2 * cross(p, q)) < 1e-5);
            for (const auto& corner : quadrilateral)
                QVERIFY(outside(triangle, corner) < 1e-12);
        }
    }

    void enlargingReachesTheDistance() {
        for (const Polygon& hull :
             {Polygon{{1, 2}}, Polygon{{0, 0}, {3, 1}}, Polygon{{0, 0}, {1, 0}, {0, 1}}}) {
            const Polygon around = enlargedHull(hull, 0.5);
            QVERIFY(isStrictlyConvex(around));
            for (const auto& corner : hull)
                for (int degrees = 0; degrees < 360; ++degrees) {
                    const double angle = degrees * std::numbers::pi / 180;
                    QVERIFY(outside(around, corner + 0.5 * Vector<2>(std::cos(angle), std::sin(angle))) <
                            1e-15);
                }
            for (const auto& corner : around)
                QVERIFY(distanceToConvex(hull, corner) <= 0.5 * std::sqrt(2) + 1e-15);
        }
    }

    void regularPolygons() {
        const Polygon square = regularPolygonAround({{0, 0}, {3, 0}, {3, 2}}, 4);
        const double side = (square[1] - square[0]).norm();
        QVERIFY(std::abs(side - 3) < 1e-9 && std::abs(square[0].y() - square[1].y()) < 1e-12);
        QVERIFY(square[0].x() < square[1].x() && square[0].y() < square[2].y());
        // A triangle that is regular and level is its own.
        const Polygon hull{{0, 0}, {1, 0}, {.5, std::sqrt(3) / 2}}, triangle = regularPolygonAround(hull, 3);
        for (std::size_t k = 0; k < 3; ++k)
            QVERIFY((triangle[k] - hull[k]).norm() < 1e-8);
        const Polygon pentagon = regularPolygonAround({{2, 1}}, 5);
        for (std::size_t k = 0; k < 5; ++k) {
            QVERIFY(std::abs((pentagon[k] - Vector<2>(2, 1)).norm() - 1 / std::cos(std::numbers::pi / 5)) <
                    1e-12);
            QVERIFY(std::abs((pentagon[k] - pentagon[(k + 1) % 5]).norm() -
                             2 * std::tan(std::numbers::pi / 5)) < 1e-12);
        }
    }
};

BARYCAGE_TEST(HullCageTest);
#include "hull_cage_test.moc"
