// SPDX-License-Identifier: MIT
#include "ifs/cage/map_handles.h"
#include "ifs/canonical_systems.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>

using namespace ifs;
using namespace canonical;

namespace {

using Polygon = std::vector<Vector<2>>;

const Polygon unitTriangle{{0, 0}, {1, 0}, {0, 1}};

Polygon somePolygon(Random& random, int corners) {
    std::uniform_real_distribution<double> radius(0.6, 1.4);
    Polygon polygon;
    for (int k = 0; k < corners; ++k) {
        const double angle = 2 * M_PI * k / corners;
        polygon.emplace_back(3 + radius(random) * std::cos(angle), radius(random) * std::sin(angle) - 2);
    }
    return polygon;
}

} // namespace

class MapHandlesTest : public QObject {
    Q_OBJECT

private slots:
    void aHandleOfTheSierpinskiTriangle() {
        const AffineMap<2> before = sierpinskiRight()[0];
        const AffineMap<2> after = withHandleMoved(before, unitTriangle, 1, {0.1, 0.1});
        const AffineMap<2> expected = affineMap(.6, 0, .1, .5, 0, 0);
        QVERIFY((after.linear - expected.linear).norm() < 1e-15);
        QVERIFY(after.translation.norm() < 1e-15);
        QVERIFY(std::abs(spectralNorm<2>(after.linear) - 0.622978728978) < 1e-12);
        QVERIFY(withHandleMoved(before, unitTriangle, 1, {0, 0}) == before);
    }

    // The dragged image follows the pointer. Of a triangle the two others stay, of any polygon two of them,
    // and the change has rank one.
    void otherHandlesStay() {
        Random random(7);
        std::uniform_real_distribution<double> number(-1, 1);
        for (int corners = 3; corners < 12; ++corners)
            for (int n = 0; n < 20; ++n) {
                const Polygon rest = somePolygon(random, corners);
                const AffineMap<2> map = affineMap(number(random), number(random), number(random),
                                                   number(random), number(random), number(random));
                const std::size_t vertex = random() % rest.size();
                const Vector<2> offset(number(random), number(random));
                const AffineMap<2> after = withHandleMoved(map, rest, vertex, offset);
                QVERIFY((after(rest[vertex]) - map(rest[vertex]) - offset).norm() < 1e-13);
                const auto stays = std::ranges::count_if(
                    rest, [&](const Vector<2>& v) { return (after(v) - map(v)).norm() < 1e-13; });
                QVERIFY(stays >= 2);
                QVERIFY(std::abs(determinant<2>(after.linear - map.linear)) < 1e-13);
            }
    }

    // The vertices next to a dragged one may lie on one line with it.
    void aVertexInTheMiddleOfAnEdgeCanBeTaken() {
        const Polygon rest{{0, 0}, {1, 0}, {2, 0}, {0, 2}};
        const AffineMap<2> after = withHandleMoved(AffineMap<2>{}, rest, 1, {0.3, 0.2});
        QVERIFY((after(rest[1]) - Vector<2>(1.3, 0.2)).norm() < 1e-15);
    }

    void preimagesUndoThePlacement() {
        const Polygon rest{{0, 0}, {4, 0}, {4, 3}, {0, 3}};
        const ControlCage<2> bent{rest, {{0, 0}, {5, 0.5}, {3.5, 3}, {-0.5, 2.5}}};
        const Placement placement(bent, Coordinates::MeanValue);
        QVERIFY(placement.bend() != nullptr);
        Random random(3);
        std::uniform_real_distribution<double> x(0.2, 3.8), y(0.2, 2.8);
        for (int n = 0; n < 100; ++n) {
            const Vector<2> point(x(random), y(random));
            const auto back = preimage(placement, placement(point), {2, 1.5});
            QVERIFY(back && (*back - point).norm() < 1e-9);
            const AffineMap<2> local = firstOrder(placement, point);
            const Vector<2> step(1e-4, -2e-4);
            QVERIFY((local(point) - placement(point)).norm() < 1e-12);
            QVERIFY((local(point + step) - placement(point + step)).norm() < 1e-7);
        }
        QVERIFY(!preimage(Placement(affineMap(1, 2, 2, 4, 0, 0)), {1, 1}, {0, 0})); // flat
    }

    // A half grows with t: it stops contracting where t + 0.5 = 1.
    void theWayEndsWhereTheAttractorDoes() {
        const auto grown = [](double t) {
            Maps2 maps = sierpinskiRight();
            maps[1].linear = (0.5 + t) * Matrix<2>::Identity();
            return maps;
        };
        const SafeWay<2> way = safeWay<2>(grown);
        QVERIFY(std::abs(way.share - 0.5) < 1.1e-3);
        QCOMPARE(way.verdict.verdict, Verdict::None);
        QCOMPARE(way.verdict.witness, std::vector<int>{1});
        QVERIFY(spectralNorm<2>(way.past[1].linear) >= 1);
        QVERIFY(hasAttractor(classify<2>(grown(way.share))));

        QCOMPARE(safeWay<2>([&](double t) { return grown(t * 0.4); }).share, 1.0);
        QCOMPARE(safeWay<2>([&](double t) { return grown(0.6 - t * 0.3); }).share, 1.0); // nothing to keep
        QCOMPARE(safeWay<2>([&](double t) { return grown(0.6 + t); }).share, 1.0);
    }

    // The tetrahedron 0, e₁, e₂, e₃ and halves: the corner of the first half at e₁ moved by (0.1, 0.1, 0).
    void inSpaceACornerMovesAlone() {
        const Simplex<3> rest{Vector<3>(0, 0, 0), Vector<3>(1, 0, 0), Vector<3>(0, 1, 0), Vector<3>(0, 0, 1)};
        const AffineMap<3> half{0.5 * Matrix<3>::Identity(), Vector<3>::Zero()};
        const AffineMap<3> moved = withHandleMoved(half, rest, 1, Vector<3>(0.1, 0.1, 0));
        Matrix<3> expected = half.linear;
        expected(0, 0) = 0.6;
        expected(1, 0) = 0.1;
        QVERIFY((moved.linear - expected).norm() < 1e-15 && moved.translation.isZero(0));

        const Simplex<3> skew{Vector<3>(1, 2, -1), Vector<3>(3, 1, 0), Vector<3>(0, 4, 1),
                              Vector<3>(1, 1, 5)};
        const AffineMap<3> map{Vector<3>(0.2, -0.4, 0.3).asDiagonal() * Matrix<3>::Ones(), {1, 2, 3}};
        for (std::size_t vertex = 0; vertex < 4; ++vertex) {
            const Vector<3> offset(0.3, -0.7, 0.2);
            const AffineMap<3> after = withHandleMoved(map, skew, vertex, offset);
            for (std::size_t other = 0; other < 4; ++other) {
                const Vector<3> wanted = map(skew[other]) + (other == vertex ? offset : Vector<3>::Zero());
                QVERIFY((after(skew[other]) - wanted).norm() < 1e-13);
            }
        }
        QVERIFY(withHandleMoved(map, skew, 2, Vector<3>::Zero()) == map);
    }

    void inSpaceTheWayEndsWhereTheAttractorDoes() {
        const auto grown = [](double t) {
            return std::vector<AffineMap<3>>{{0.5 * Matrix<3>::Identity(), Vector<3>::Zero()},
                                             {(0.5 + t) * Matrix<3>::Identity(), Vector<3>::Ones()}};
        };
        const SafeWay<3> way = safeWay<3>(grown);
        QVERIFY(std::abs(way.share - 0.5) < 1.1e-3);
        QCOMPARE(way.verdict.witness, std::vector<int>{1});
        QCOMPARE(safeWay<3>([&](double t) { return grown(t * 0.4); }).share, 1.0);
    }

    // A norm above 1 is no reason to stop: sheared, every map of the flower has one.
    void aNormAboveOneIsNoEnd() {
        const auto sheared = [](double t) {
            Maps2 maps;
            for (const AffineMap<2>& map : flower())
                maps.push_back(*conjugate(affineMap(1, 3 * t, 0, 1, 0, 0), map));
            return maps;
        };
        QVERIFY(spectralNorm<2>(sheared(1)[0].linear) > 3);
        QCOMPARE(safeWay<2>(sheared).share, 1.0);
    }
};

BARYCAGE_TEST(MapHandlesTest);
#include "map_handles_test.moc"
