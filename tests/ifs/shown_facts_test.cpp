// SPDX-License-Identifier: MIT
#include "ifs/shown_facts.h"

#include "ifs/canonical_systems.h"
#include "ifs/extent/polygon.h"
#include "support/named_test.h"
#include "support/near.h"

#include <QtTest>

#include <random>

using namespace ifs;
using namespace canonical;
using support::near;

namespace {

template <int Dim> IteratedFunctionSystem<Dim> systemOf(const std::vector<AffineMap<Dim>>& maps) {
    IteratedFunctionSystem<Dim> system;
    double weight = 1;
    for (const auto& map : maps)
        append(system, map, weight += 0.5);
    return system;
}

AffineMap<2> shift(double x, double y) {
    return affineMap(1, 0, 0, 1, x, y);
}

} // namespace

// A picture in which branches are moved.
class ShownFactsTest : public QObject {
    Q_OBJECT

private slots:
    void gasketWithACornerTakenAway();
    void piecesThatStayChangeNothing();
    void everyPointIsInside();
    void solids();
    void linkedMapsHaveNoExtents();
};

void ShownFactsTest::gasketWithACornerTakenAway() {
    IteratedFunctionSystem<2> system;
    for (const auto& map :
         {affineMap(.5, 0, 0, .5, 0, 0), affineMap(.5, 0, 0, .5, .5, 0), affineMap(.5, 0, 0, .5, 0, .5)})
        append(system, map, 1);
    const Facts<2> code = geometricFacts(system);
    const std::vector<MovedBranch<2>> moved{{{0}, shift(-3, 0)}};
    const Facts<2> facts = shown<2>(code, code, {}, pieces<2>(moved, 3));
    QVERIFY((facts.box->min - Vector<2>(-3, 0)).norm() < 1e-12);
    QVERIFY((facts.box->max - Vector<2>(1, 1)).norm() < 1e-12);
    QCOMPARE(facts.hull->vertices.size(), std::size_t(4));
    // (−3, 0), (1, 0), (0, 1), (−3, 1/2)
    QVERIFY(near(facts.hull->area, 0.5 * (3 * 0.5 + 3 * 1) + 0.5, 1e-9));
    QVERIFY((facts.mean->point - Vector<2>(-2.0 / 3, 1.0 / 3)).norm() < 1e-14);
    QVERIFY((facts.moments->mean - facts.mean->point).norm() == 0);
    // x: a third of the three squares, and a quarter of the variance 2/27 of the gasket
    const double x = (std::pow(-17.0 / 6 + 2.0 / 3, 2) + std::pow(4.0 / 3, 2) + std::pow(5.0 / 6, 2)) / 3;
    QVERIFY(near(facts.moments->covariance(0, 0), x + code.moments->covariance(0, 0) / 4, 1e-14));
    QVERIFY(facts.moments->covarianceError < 1e-12);
    QCOMPARE(facts.similarityDimension, code.similarityDimension);

    const Facts<2> placed = shown<2>(code, code, affineMap(0, -2, 2, 0, 1, 1), pieces<2>(moved, 3));
    QVERIFY((placed.box->min - Vector<2>(-1, -5)).norm() < 1e-12);
    QVERIFY(near(placed.hull->area, 4 * facts.hull->area, 1e-9));
}

void ShownFactsTest::piecesThatStayChangeNothing() {
    const Facts<2> code = geometricFacts(systemOf(maple()));
    const std::vector<MovedBranch<2>> moved{{{1, 0, 2}, {}}, {{3}, {}}};
    const Facts<2> facts = shown<2>(code, code, {}, pieces<2>(moved, 4));
    QVERIFY((facts.box->min - code.box->min).norm() < 1e-10);
    QVERIFY((facts.box->max - code.box->max).norm() < 1e-10);
    QVERIFY(near(facts.simplex->leg, code.simplex->leg, 1e-10));
    QVERIFY(near(facts.hull->area, code.hull->area, 1e-5));
    QVERIFY((facts.moments->mean - code.moments->mean).norm() < 1e-13);
    QVERIFY((facts.moments->covariance - code.moments->covariance).norm() < 1e-13);
}

void ShownFactsTest::everyPointIsInside() {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> step(-1, 1);
    for (int trial = 0; trial < 10; ++trial) {
        const IteratedFunctionSystem<2> system = systemOf(maple());
        const Facts<2> code = geometricFacts(system);
        std::vector<MovedBranch<2>> moved;
        for (const Word& word : {Word{0}, Word{2, 1}, Word{2, 1, 3}, Word{3, 3}})
            moved.push_back({word, affineMap(1 + step(random), step(random), step(random), 1 + step(random),
                                             step(random), step(random))});
        const auto all = pieces<2>(moved, 4);
        const Facts<2> facts = shown<2>(code, code, {}, all);
        const BoundingBox<2>& box = *facts.box;
        std::uniform_int_distribution<int> die(0, 3);
        std::vector<Vector<2>> points;
        Word address;
        for (int n = 0; n < 20'000; ++n) {
            address.clear();
            for (int k = 0; k < 60; ++k)
                address.push_back(die(random));
            Vector<2> point = code.mean->point;
            for (auto symbol = address.rbegin(); symbol != address.rend(); ++symbol)
                point = code.active.maps[std::size_t(*symbol)](point);
            point = pieceOf<2>(all, address).change(point);
            points.push_back(point);
            const double room = box.error + 1e-9;
            QVERIFY((point - box.min).minCoeff() > -room && (box.max - point).minCoeff() > -room);
            QVERIFY(distanceToConvex(facts.hull->vertices, point) <= facts.hull->error + 1e-9);
        }
        const Polygon seen = convexHull(points, 0);
        QVERIFY(area(seen) > 0.95 * facts.hull->area); // and the hull is no larger than it has to be
    }
}

void ShownFactsTest::solids() {
    std::vector<AffineMap<3>> maps;
    for (const Vector<3>& corner :
         {Vector<3>(0, 0, 0), Vector<3>(1, 0, 0), Vector<3>(0, 1, 0), Vector<3>(0, 0, 1)}) {
        AffineMap<3> map;
        map.linear = 0.5 * Matrix<3>::Identity();
        map.translation = 0.5 * corner;
        maps.push_back(map);
    }
    const Facts<3> code = geometricFacts(systemOf<3>(maps));
    MovedBranch<3> up{{3}, {}};
    up.change.translation.z() = 4;
    const Facts<3> facts = shown<3>(code, code, {}, pieces<3>(std::vector{up}, 4));
    QVERIFY((facts.box->min - code.box->min).norm() < 1e-12);
    QVERIFY((facts.box->max - Vector<3>(1, 1, 5)).norm() < 1e-12);
    QVERIFY(!facts.hull);
}

void ShownFactsTest::linkedMapsHaveNoExtents() {
    IteratedFunctionSystem<2> system = systemOf(maple());
    const std::vector<MovedBranch<2>> moved{{{0}, shift(5, 0)}};
    system.links = {{system.maps[0].id, system.maps[1].id, 0}};
    const Facts<2> code = geometricFacts(system);
    QVERIFY(code.box.has_value());
    const Facts<2> facts = shown<2>(code, code, {}, pieces<2>(moved, 4));
    QVERIFY(!facts.box && !facts.hull && !facts.simplex && !facts.mean && !facts.moments);
}

BARYCAGE_TEST(ShownFactsTest);
#include "shown_facts_test.moc"
