// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
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
