// SPDX-License-Identifier: MIT
#include "ifs/facts.h"

#include "support/named_test.h"
#include "support/near.h"

#include <QtTest>

#include <array>
#include <vector>

using namespace ifs;
using support::near;

namespace {

using Numbers = std::array<Surd, 6>; // a b c d e f

const Surd third = Surd(1) / Surd(3), two_thirds = Surd(2) / Surd(3);
const Surd root3 = Surd::root(3);

// The doubles next to these numbers, with the numbers where they are typed.
IteratedFunctionSystem<2> typedSystem(const std::vector<Numbers>& maps, bool areTyped = true) {
    IteratedFunctionSystem<2> system;
    for (const Numbers& numbers : maps) {
        std::array<double, 6> stored{};
        for (std::size_t i = 0; i < stored.size(); ++i)
            stored[i] = numbers[i].rounded();
        const auto [a, b, c, d, e, f] = stored;
        append(system, affineMap(a, b, c, d, e, f), 1.0);
        for (std::size_t i = 0; areTyped && i < stored.size(); ++i)
            system.maps.back().typed.set({int(i), stored[i], numbers[i], "as typed"});
    }
    return system;
}

// x ↦ x/3 + digit/3 on a line.
std::vector<Numbers> thirds(const std::vector<Surd>& digits) {
    std::vector<Numbers> maps;
    for (const Surd& digit : digits)
        maps.push_back({third, 0, 0, third, digit * third, 0});
    return maps;
}

std::vector<Numbers> typedKoch() {
    const Surd half = Surd(1) / Surd(6), high = root3 / Surd(6);
    return {{third, 0, 0, third, 0, 0},
            {half, -high, high, half, third, 0},
            {half, high, -high, half, Surd(1) / Surd(2), high},
            {third, 0, 0, third, two_thirds, 0}};
}

// With the corners (0, 0), (1, 0) and (0, 1).
std::vector<Numbers> typedGasket() {
    const Surd ratio = (Surd::root(5) - Surd(1)) / Surd(2), rest = Surd(1) - ratio;
    return {{ratio, 0, 0, ratio, 0, 0}, {ratio, 0, 0, ratio, rest, 0}, {ratio, 0, 0, ratio, 0, rest}};
}

} // namespace

// What is known of doubles to rounding is proved of the numbers that they round.
class TypedFactsTest : public QObject {
    Q_OBJECT

private slots:
    void theOpenSetConditionIsProved_data() {
        QTest::addColumn<int>("which");
        QTest::newRow("Koch") << 0;
        QTest::newRow("thirds 0 1 2") << 1;
    }
    void theOpenSetConditionIsProved() {
        QFETCH(const int, which);
        const std::vector<Numbers> maps = which == 0 ? typedKoch() : thirds({0, 1, 2});
        const OpenSetFacts stored = *factsOf(typedSystem(maps, false)).invariants.openSet;
        QCOMPARE(stored.condition, OpenSetCondition::Holds);
        const OpenSetFacts typed = *factsOf(typedSystem(maps)).invariants.openSet;
        QCOMPARE(typed.condition, OpenSetCondition::Holds);
        QCOMPARE(typed.certainty, Certainty::Exact);
        QVERIFY(typed.dimension);
        QCOMPARE(typed.dimension->certainty, Certainty::Exact);
        QCOMPARE(typed.dimension->value, stored.dimension->value);
        // Of thirds as they are stored, it is proved as well: the segments do not overlap.
        QVERIFY(which == 1 || stored.certainty == Certainty::ToRounding ||
                stored.dimension->certainty == Certainty::ToRounding);
    }
    void kochIsConnected() {
        QCOMPARE(factsOf(typedSystem(typedKoch(), false)).invariants.contacts->connectedness,
                 Connectedness::ConnectedToRounding);
        QCOMPARE(factsOf(typedSystem(typedKoch())).invariants.contacts->connectedness,
                 Connectedness::Connected);
    }
    // 03 = 10, as of the digits 0, 1 and 3.
    void overlapsAreProved() {
        const std::vector<Numbers> maps = thirds({0, Surd(1) / Surd(7), Surd(3) / Surd(7)});
        const Facts<2> stored = factsOf(typedSystem(maps, false));
        QVERIFY(!stored.invariants.contacts->overlaps.empty());
        QVERIFY(!stored.invariants.contacts->overlaps.front().isExact);
        const Facts<2> typed = factsOf(typedSystem(maps));
        QVERIFY(typed.invariants.contacts->overlaps.front().isExact);
        QCOMPARE(typed.invariants.openSet->condition, OpenSetCondition::Fails);
        QCOMPARE(typed.invariants.openSet->certainty, Certainty::Exact);
        QCOMPARE(typed.invariants.openSet->dimension->certainty, Certainty::Exact);
        QVERIFY(near(typed.invariants.openSet->dimension->value, 0.8760357589718848, 1e-12));
    }
    void theGoldenGasketOverlaps() {
        const OpenSetFacts typed = *factsOf(typedSystem(typedGasket())).invariants.openSet;
        QCOMPARE(typed.condition, OpenSetCondition::Fails);
        QCOMPARE(typed.certainty, Certainty::Exact);
        QVERIFY(typed.dimension);
        QCOMPARE(typed.dimension->certainty, Certainty::Exact);
        QVERIFY(near(typed.dimension->value, 1.9306354508224262, 1e-12));
    }
    // The square of nine, and the terdragon, whose ratio is 1/√3.
    void areasOfTilesAreProved() {
        std::vector<Numbers> square;
        for (int i = 0; i < 9; ++i)
            square.push_back({third, 0, 0, third, Surd(i % 3) * third, Surd(i / 3) * third});
        const Surd half = Surd(1) / Surd(2), sixth = root3 / Surd(6);
        const std::vector<Numbers> terdragon{{half, sixth, -sixth, half, 0, 0},
                                             {half, sixth, -sixth, half, half, sixth},
                                             {half, sixth, -sixth, half, half, -sixth}};
        for (const auto& maps : {square, terdragon}) {
            const Tile stored = *factsOf(typedSystem(maps, false)).invariants.tile;
            QVERIFY(stored.area && !stored.isExact);
            const Tile typed = *factsOf(typedSystem(maps)).invariants.tile;
            QVERIFY(typed.isExact);
            QCOMPARE(typed.area, stored.area);
        }
        square[8][4] = square[8][4] + Surd(1) / Surd(std::int64_t(1) << 56);
        QCOMPARE(square[8][4].rounded(), 2.0 / 3);
        QVERIFY(!factsOf(typedSystem(square)).invariants.tile->isExact);
    }
    // 3 + 2⁻⁵⁰ has the same double over 3, and no two words the same map.
    void whatOnlyRoundsTheSameIsNotProved() {
        const Surd almost = Surd(3) + Surd(1) / Surd(std::int64_t(1) << 53);
        const std::vector<Numbers> maps = thirds({0, 1, almost});
        QCOMPARE(maps[2][4].rounded(), 1.0);
        const Invariants typed = factsOf(typedSystem(maps)).invariants;
        QVERIFY(!typed.contacts->overlaps.front().isExact);
        QCOMPARE(typed.openSet->certainty, Certainty::ToRounding);
    }
    // Triangles that touch in doubles, and lie a little apart as they are typed.
    void whatOnlyTouchesRoundedIsNotConnected() {
        const Surd half = Surd(1) / Surd(2), less = half - Surd(1) / Surd(std::int64_t(1) << 60);
        QCOMPARE(less.rounded(), 0.5);
        const auto gasket = [&](const Surd& ratio) {
            return std::vector<Numbers>{
                {ratio, 0, 0, ratio, 0, 0}, {ratio, 0, 0, ratio, half, 0}, {ratio, 0, 0, ratio, 0, half}};
        };
        const Invariants touching = factsOf(typedSystem(gasket(half))).invariants;
        QCOMPARE(touching.contacts->connectedness, Connectedness::Connected);
        QCOMPARE(touching.openSet->certainty, Certainty::Exact);
        const Invariants apart = factsOf(typedSystem(gasket(less))).invariants;
        QVERIFY(apart.contacts->connectedness != Connectedness::Connected);
        QVERIFY(apart.openSet->condition == OpenSetCondition::Unknown ||
                apart.openSet->certainty == Certainty::ToRounding);
        // The same with a square, whose hull is the union of its images.
        std::vector<Numbers> square = gasket(less);
        square.push_back({less, 0, 0, less, half, half});
        QVERIFY(factsOf(typedSystem(square)).invariants.contacts->connectedness != Connectedness::Connected);
    }
    // 1/2 is the double 0.5, of which all is known that doubles tell.
    void whatIsStoredAsTypedIsAsStored() {
        const Surd half = Surd(1) / Surd(2);
        const IteratedFunctionSystem<2> system =
            typedSystem({{half, 0, 0, half, 0, 0}, {half, 0, 0, half, half, 0}});
        QVERIFY(system.maps[0].typed.of(0, 0.5));
        QVERIFY(typedMaps(system, activeMaps(system)).empty());
    }
    // The number that is typed counts only while it is that of the map.
    void changedNumbersAreAsStored() {
        IteratedFunctionSystem<2> system = typedSystem(thirds({0, 1, 3}));
        system.maps[0].map.linear(0, 0) = 0.25;
        system.maps[0].map.linear(1, 1) = 0.25;
        QVERIFY(system.maps[0].typed.of(0, 1.0 / 3));
        QVERIFY(!system.maps[0].typed.of(0, system.maps[0].map));
        const auto typed = typedMaps(system, activeMaps(system));
        QVERIFY(typed.front().linear[0][0] == Surd(1) / Surd(4));
    }
    // One number that has no value leaves all as it is stored.
    void numbersOfOtherKindsProveNothing() {
        IteratedFunctionSystem<2> system = typedSystem(typedKoch());
        system.maps[1].typed.set({0, system.maps[1].map.linear(0, 0), Surd::none(), "cos(20°)"});
        QVERIFY(typedMaps(system, activeMaps(system)).empty());
        QCOMPARE(factsOf(system).invariants.contacts->connectedness, Connectedness::ConnectedToRounding);
    }
    // Products of √3 and 1 + √2 are no such numbers.
    void rootsOfTwoKindsProveNothing() {
        const auto curve = [](const Surd& length) { // Koch's, with one of the maps mirrored
            const Surd half = Surd(1) / Surd(6), high = root3 / Surd(6);
            return typedSystem({{third, 0, 0, third, 0, 0},
                                {half, -high, high, half, length * third, 0},
                                {-half, high, high, half, length * two_thirds, 0},
                                {third, 0, 0, third, length * two_thirds, 0}});
        };
        const Invariants one = factsOf(curve(Surd(1) + root3)).invariants;
        QCOMPARE(one.contacts->connectedness, Connectedness::Connected);
        QCOMPARE(one.openSet->certainty, Certainty::Exact);
        const Invariants two = factsOf(curve(Surd(1) + Surd::root(2))).invariants;
        QCOMPARE(two.contacts->connectedness, Connectedness::ConnectedToRounding);
        QCOMPARE(two.openSet->condition, OpenSetCondition::Holds);
        QCOMPARE(two.openSet->certainty, Certainty::ToRounding);
    }
    void copiesBySymmetryProveNothing() {
        IteratedFunctionSystem<2> system = typedSystem(thirds({0, 1}));
        system.symmetry.group = SymmetryGroup::Rotation;
        system.symmetry.order = 3;
        QVERIFY(typedMaps(system, activeMaps(system)).empty());
    }
    void mapsThatAreOffDoNotCount() {
        IteratedFunctionSystem<2> system = typedSystem(typedKoch());
        system.maps[1].enabled = false;
        QCOMPARE(typedMaps(system, activeMaps(system)).size(), std::size_t(3));
    }
    void valuesAreShared() {
        IteratedFunctionSystem<2> system = typedSystem(typedKoch());
        const IteratedFunctionSystem<2> copy = system;
        QVERIFY(copy == system);
        system.maps[0].typed.clear(0);
        QVERIFY(!(copy == system));
        QVERIFY(copy.maps[0].typed.of(0, copy.maps[0].map));
    }
};

BARYCAGE_TEST(TypedFactsTest, QCoreApplication);
#include "typed_facts_test.moc"
