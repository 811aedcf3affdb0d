// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/system/decomposition.h"
#include "ifs/system/map_interpolation.h"
#include "support/named_test.h"

#include <QtTest>

#include <numbers>

using namespace ifs;
using namespace canonical;

namespace {

template <int Dim> void properties() {
    Random random(Dim);
    for (int n = 0; n < 300; ++n) {
        const auto maps = randomContractions<Dim>(random, 2, 0.95);
        const Vector<Dim> reference = randomVector<Dim>(random, 2);
        QCOMPARE(interpolated<Dim>(maps[0], maps[1], 0, reference), maps[0]);
        QCOMPARE(interpolated<Dim>(maps[0], maps[1], 1, reference), maps[1]);
        const double largest = std::max(spectralNorm<Dim>(maps[0].linear), spectralNorm<Dim>(maps[1].linear));
        for (const double t : {1e-9, 0.1, 0.5, 0.9, 1 - 1e-9}) {
            const auto map = interpolated<Dim>(maps[0], maps[1], t, reference);
            QVERIFY(spectralNorm<Dim>(map.linear) <= largest * (1 + 1e-14));
            const Vector<Dim> straight = (1 - t) * maps[0](reference) + t * maps[1](reference);
            QVERIFY((map(reference) - straight).norm() < 1e-14 * 8);
            const auto& end = maps[t < 0.5 ? 0 : 1];
            if (t < 1e-6 || t > 1 - 1e-6) QVERIFY((map.linear - end.linear).norm() < 1e-7);
        }
    }
}

} // namespace

class MapInterpolationTest : public QObject {
    Q_OBJECT

private slots:
    void halfwayInMaple() {
        const auto map = interpolated<2>(maple()[2], maple()[3], 0.5, {0, 0});
        Matrix<2> expected;
        expected << 0.682530784204, 0.011884611023, -0.061757061898, 0.595299372995;
        QVERIFY((map.linear - expected).cwiseAbs().maxCoeff() < 1e-12);
        const Vector<2> sigma = singularValues<2>(map.linear);
        QVERIFY((sigma - Vector<2>(0.690216067084, 0.589734325172)).cwiseAbs().maxCoeff() < 1e-12);
    }

    void turnsTheShortWay() {
        const auto at = [](double degrees) {
            return similarity(0.5, degrees * std::numbers::pi / 180, 0, 0);
        };
        const auto middle = [&](double from, double to) {
            return interpolated<2>(at(from), at(to), 0.5, {0, 0}).linear;
        };
        QVERIFY((middle(170, -170) - at(180).linear).norm() < 1e-15);
        QVERIFY((middle(-10, 30) - at(10).linear).norm() < 1e-15);
        QVERIFY(mirrors<2>(at(0), affineMap(.5, 0, 0, -.5, 0, 0)) && !mirrors<2>(at(0), at(180)));
    }

    // Half a turn goes counter-clockwise, there and back.
    void aTieTurnsCounterClockwise() {
        const AffineMap<2> upright = affineMap(.5, 0, 0, .5, 0, 0), turned = affineMap(-.5, 0, 0, -.5, 0, 0);
        const Matrix<2> quarter = affineMap(0, -.5, .5, 0, 0, 0).linear;
        QVERIFY((interpolated<2>(upright, turned, 0.5, {0, 0}).linear - quarter).norm() < 1e-14);
        QVERIFY((interpolated<2>(turned, upright, 0.5, {0, 0}).linear + quarter).norm() < 1e-14);
    }

    void aPointGrowsWithoutTurning() {
        for (const Vector<2>& image : {Vector<2>(0, 0), Vector<2>(1, -2)}) {
            const AffineMap<2> point{Matrix<2>::Zero(), image};
            const AffineMap<2> map = affineMap(0, -.5, .5, 0, 0, 0);
            for (const double t : {0.25, 0.5}) {
                QVERIFY((interpolated<2>(point, map, t, {1, 1}).linear - t * map.linear).norm() < 1e-16);
                QVERIFY((interpolated<2>(map, point, 1 - t, {1, 1}).linear - t * map.linear).norm() < 1e-16);
            }
        }
        const AffineMap<2> still{Matrix<2>::Zero(), {1, 0}};
        QCOMPARE(interpolated<2>(still, still, 0.5, {1, 1}), still);
        Random random(5);
        for (int n = 0; n < 100; ++n) {
            const AffineMap<3> map = randomContractions<3>(random, 1, 0.95)[0];
            const AffineMap<3> point{Matrix<3>::Zero(), randomVector<3>(random, 1)};
            QVERIFY((interpolated<3>(point, map, 0.5, {1, 1, 1}).linear - map.linear / 2).norm() < 1e-14);
            QVERIFY((interpolated<3>(map, point, 0.5, {1, 1, 1}).linear - map.linear / 2).norm() < 1e-14);
        }
    }

    // A line of space has no turn about itself: that of the other map is its own.
    void aLineTurnsNoMoreThanItMust() {
        Random random(6);
        for (int n = 0; n < 100; ++n) {
            const Matrix<3> turn = polar<3>(randomContractions<3>(random, 1, 0.95)[0].linear).rotation;
            const Vector<3> axis = randomVector<3>(random, 1).normalized();
            const AffineMap<3> map{0.5 * turn, {0, 0, 0}};
            const AffineMap<3> line{0.5 * turn * axis * axis.transpose(), {0, 0, 0}};
            const Matrix<3> middle = (map.linear + line.linear) / 2;
            QVERIFY((interpolated<3>(line, map, 0.5, {1, 1, 1}).linear - middle).norm() < 1e-13);
            QVERIFY((interpolated<3>(map, line, 0.5, {1, 1, 1}).linear - middle).norm() < 1e-13);
            const AffineMap<3> point{Matrix<3>::Zero(), {0, 0, 0}};
            QVERIFY((interpolated<3>(point, line, 0.5, {1, 1, 1}).linear - line.linear / 2).norm() < 1e-14);
            QVERIFY((interpolated<3>(line, point, 0.5, {1, 1, 1}).linear - line.linear / 2).norm() < 1e-14);
        }
    }

    // What is nearly a point or a line turns like it.
    void oneDimensionalMapsAreLimits() {
        const AffineMap<2> map = affineMap(.1, -.5, .4, .2, 0, 0);
        const AffineMap<2> nearly{1e-9 * map.linear, {0, 0}}, point{Matrix<2>::Zero(), {0, 0}};
        const Matrix<2> expected = interpolated<2>(nearly, map, 0.5, {0, 0}).linear;
        QVERIFY((interpolated<2>(point, map, 0.5, {0, 0}).linear - expected).norm() < 1e-8);
        const AffineMap<2> line = affineMap(0, 0, .5, 0, 0, 0), thick = affineMap(0, -1e-9, .5, 0, 0, 0);
        const Matrix<2> of = interpolated<2>(thick, map, 0.5, {0, 0}).linear;
        QVERIFY((interpolated<2>(line, map, 0.5, {0, 0}).linear - of).norm() < 1e-8);
    }

    // The base of the branch stays, the rest turns about it.
    void swingsAboutItsBase() {
        const auto map = maple()[2];
        const Vector<2> root(0.3, -3), base = map(root);
        QCOMPARE(swung(map, root, 0), map);
        for (const double angle : {0.2, -1.0, 3.0}) {
            const auto turned = swung(map, root, angle);
            QVERIFY((turned(root) - base).norm() < 1e-15 * 8);
            QVERIFY(std::abs(spectralNorm<2>(turned.linear) - spectralNorm<2>(map.linear)) < 1e-15 * 4);
            const Vector<2> x(1, 2), before = map(x) - base, after = turned(x) - base;
            const double turn =
                std::atan2(before.x() * after.y() - before.y() * after.x(), before.dot(after));
            QVERIFY(std::abs(turn - angle) < 1e-13);
        }
    }

    void swingIsPeriodic() {
        const Swing swing{0.4, 2, 0.5};
        QCOMPARE(Swing{}.angle(7.3), 0.0);
        QCOMPARE(swing.angle(0), 0.4 * std::sin(0.5));
        QVERIFY(std::abs(swing.angle(0.3) - swing.angle(0.8)) < 1e-14);
        QVERIFY(std::abs(swing.angle(0.3) - swing.angle(0.55)) > 0.1);
    }

    void planeProperties() { properties<2>(); }
    void spaceProperties() { properties<3>(); }
};

BARYCAGE_TEST(MapInterpolationTest);
#include "map_interpolation_test.moc"
