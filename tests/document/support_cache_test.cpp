// SPDX-License-Identifier: MIT
#include "document/fractal/support_cache.h"

#include "document/fractal/fractal.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "support/fractals.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

using document::Fractal;
using document::SupportCache;

namespace {

// 300 maps that shrink by 20 to places around a circle of that radius.
document::System2 ring(double radius) {
    constexpr int count = 300;
    document::System2 system;
    for (int k = 0; k < count; ++k)
        ifs::append(system, ifs::affineMap(0.05, 0, 0, 0.05, radius * std::cos(k), radius * std::sin(k)));
    return system;
}

// Maps that shrink to places all over a sphere of radius 1, as the golden angle sets them.
Fractal shell(std::size_t count) {
    document::Shape<3> shape;
    for (std::size_t k = 0; k < count; ++k) {
        const double y = 1 - (2 * double(k) + 1) / double(count);
        const double ring = std::sqrt(1 - y * y);
        const double angle = 2.399963229728653 * double(k);
        ifs::append<3>(shape.system, {0.05 * ifs::Matrix<3>::Identity(),
                                      ifs::Vector<3>(ring * std::cos(angle), y, ring * std::sin(angle))});
    }
    Fractal fractal;
    fractal.shape = std::move(shape);
    return fractal;
}

} // namespace

class SupportCacheTest : public QObject {
    Q_OBJECT

private slots:
    void remembersTheNewest() {
        const SupportCache cache;
        const auto first = cache.support(ring(1));
        QVERIFY(first);
        QCOMPARE(cache.support(ring(1)), first);
        for (const double radius : {2, 3, 4})
            QVERIFY(cache.support(ring(radius)) != first);
        QCOMPARE(cache.support(ring(1)), first);
        const auto fifth = cache.support(ring(5));
        QCOMPARE(cache.support(ring(5)), fifth);
        const auto again = cache.support(ring(1)); // the oldest had to go
        QVERIFY(again && again != first);
        QCOMPARE(again->radius(), first->radius());
    }

    void systemWithoutAttractor() {
        document::System2 system = ring(1);
        system.maps[7].map.linear *= 100;
        const SupportCache cache;
        QVERIFY(!cache.support(system));
        QVERIFY(!cache.support(system));
        system.maps[7].enabled = false;
        QVERIFY(cache.support(system));
    }

    void copiesOfAFractalShareIt() {
        const Fractal fractal = support::fractalOf(ring(1));
        Fractal moved = fractal;
        document::plane(moved)->cage = document::effectiveCage(fractal);
        document::plane(moved)->cage->current[0] *= 2;
        QCOMPARE(document::supportFunction(moved), document::supportFunction(fractal));
        Fractal other = moved;
        other.shape = document::Shape<2>{ring(2)};
        QVERIFY(document::supportFunction(other) != document::supportFunction(fractal));
        QCOMPARE(document::supportFunction(moved), document::supportFunction(fractal));
    }

    void itIsNoPartOfTheValue() {
        const Fractal fractal = support::fractalOf(ring(1));
        const Fractal alike = support::fractalOf(ring(1));
        const auto support = document::supportFunction(fractal);
        QVERIFY(fractal == alike);
        QVERIFY(document::supportFunction(alike) != support); // nothing is known beyond a fractal's copies
        Fractal from = fractal;
        const Fractal to = std::move(from);
        QCOMPARE(document::supportFunction(to), support);
        from = support::fractalOf(ring(1)); // what was moved from can be used again
        QVERIFY(document::supportFunction(from));
    }

    void inSpaceTheSimplexOfManyMapsHasToBeFound() {
        const Fractal many = shell(document::manyMapsInSpace + 1);
        QVERIFY(!document::isSpaceExtentKnown(many));
        QVERIFY(!document::knownSpaceCage(many));
        const auto cage = document::spaceCage(many);
        QVERIFY(document::isSpaceExtentKnown(many));
        QVERIFY(document::knownSpaceCage(many) == cage);
        QCOMPARE(document::spaceSupport(many), document::spaceSupport(many));
        // It contains the attractor, which reaches farther than the shell that the maps lead to.
        for (int axis = 0; axis < 3; ++axis) {
            const auto extent = document::extentAlong(many, ifs::Vector<3>::Unit(axis));
            QVERIFY(extent.low <= -1 && extent.high >= 1);
        }
        Fractal other = many;
        document::system3(other)->maps[0].map.translation *= 2;
        QVERIFY(!document::isSpaceExtentKnown(other));
        QVERIFY(document::isSpaceExtentKnown(many)); // and still is
        const Fractal few = shell(40);
        QVERIFY(document::isSpaceExtentKnown(few));
        QVERIFY(document::knownSpaceCage(few) == document::spaceCage(few));
    }

    void whoAsksSecondInSpaceWaitsForTheFirst() {
        const Fractal fractal = shell(document::manyMapsInSpace + 1);
        std::vector<std::thread> threads;
        std::vector<std::optional<ifs::ControlCage<3>>> found(4);
        for (auto& cage : found)
            threads.emplace_back([&cage, fractal] { cage = document::spaceCage(fractal); });
        for (std::thread& thread : threads)
            thread.join();
        for (const auto& cage : found)
            QVERIFY(cage && cage == found[0]);
    }

    void manyThreadsMayAsk() {
        const Fractal fractal = support::fractalOf(ring(1));
        std::vector<std::thread> threads;
        std::vector<std::shared_ptr<const ifs::SupportFunction<2>>> found(8);
        for (auto& support : found)
            threads.emplace_back([&support, fractal] { support = document::supportFunction(fractal); });
        for (std::thread& thread : threads)
            thread.join();
        for (const auto& support : found)
            QVERIFY(support && support->radius() == found[0]->radius());
        QCOMPARE(document::supportFunction(fractal), document::supportFunction(fractal));
    }
};

BARYCAGE_TEST(SupportCacheTest);
#include "support_cache_test.moc"
