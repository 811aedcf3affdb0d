// SPDX-License-Identifier: MIT
#include "ifs/separation/neighbour_graph.h"

#include "ifs/canonical_systems.h"
#include "ifs/extent/support_function.h"
#include "ifs/facts.h"
#include "ifs/separation/exact_map.h"
#include "ifs/separation/open_set.h"
#include "support/named_test.h"
#include "support/near.h"

#include <QtTest>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>

using namespace ifs;
using namespace canonical;
using support::near;

namespace {

const double golden = (std::sqrt(5.0) - 1) / 2;

template <int Dim> IteratedFunctionSystem<Dim> systemOf(const std::vector<AffineMap<Dim>>& maps) {
    IteratedFunctionSystem<Dim> result;
    for (const auto& map : maps)
        append(result, map, 1.0);
    return result;
}

template <int Dim> Invariants invariantsFor(const std::vector<AffineMap<Dim>>& maps) {
    return factsOf<Dim>(systemOf<Dim>(maps)).invariants;
}

template <int Dim> std::optional<NeighbourGraph> graphOf(const std::vector<AffineMap<Dim>>& maps) {
    const auto support = SupportFunction<Dim>::of(maps);
    return support ? neighbourGraph<Dim>(maps, boundingBox(*support)) : std::nullopt;
}

// x ↦ rx + (1 − r)p
Maps2 towards(double ratio, const std::vector<Vector<2>>& corners) {
    Maps2 maps;
    for (const auto& corner : corners)
        maps.push_back({ratio * Matrix<2>::Identity(), (1 - ratio) * corner});
    return maps;
}

Maps2 goldenGasket() {
    return towards(golden, {{0, 0}, {1, 0}, {.5, std::sqrt(3.0) / 2}});
}

Maps2 onALine(double ratio, const std::vector<double>& digits, double across = 0) {
    Maps2 maps;
    for (const double digit : digits)
        maps.push_back(affineMap(ratio, 0, 0, across == 0 ? ratio : across, ratio * digit, 0));
    return maps;
}

Maps3 sponge() {
    Maps3 maps;
    for (int k = 0; k < 27; ++k) {
        const Vector<3> place(k % 3, k / 3 % 3, k / 9);
        if ((place.array() == 1).count() < 2) maps.push_back({Matrix<3>::Identity() / 3, place / 3});
    }
    return maps;
}

// Different maps of words of one length, counted without rounding.
std::size_t countDifferent(const Maps2& maps, int length) {
    std::vector<Word> words{{}};
    for (int n = 0; n < length; ++n) {
        std::vector<Word> longer;
        for (const Word& word : words)
            for (int i = 0; i < int(maps.size()); ++i) {
                longer.push_back(word);
                longer.back().push_back(i);
            }
        words = std::move(longer);
    }
    std::vector<ExactMap<2>> different;
    for (const Word& word : words) {
        const auto map = exactWord<2>(maps, word);
        if (std::ranges::find(different, map) == different.end()) different.push_back(map);
    }
    return different.size();
}

} // namespace

class NeighbourGraphTest : public QObject {
    Q_OBJECT

private slots:
    void openSetConditionHolds_data() {
        QTest::addColumn<Maps2>("maps");
        QTest::addColumn<bool>("isExact");
        QTest::addColumn<double>("dimension");
        QTest::newRow("Sierpiński, right-angled") << sierpinskiRight() << true << std::log2(3.0);
        QTest::newRow("Koch") << koch() << false << std::log(4.0) / std::log(3.0);
        QTest::newRow("Lévy") << levy() << true << 2.0;
        QTest::newRow("Heighway") << heighway() << true << 2.0;
        QTest::newRow("twindragon") << twin() << true << 2.0;
        Maps2 carpet;
        for (int k = 0; k < 9; ++k)
            if (k != 4) carpet.push_back(affineMap(1. / 3, 0, 0, 1. / 3, k % 3 / 3., k / 3 / 3.));
        // As stored, too, its squares do not overlap.
        QTest::newRow("carpet") << carpet << true << std::log(8.0) / std::log(3.0);
        // A set of all numbers with digits 0 and 2 in base 4, on a line of the plane.
        QTest::newRow("dust") << onALine(.25, {0, 2}) << true << .5;
        QTest::newRow("interval") << onALine(.5, {0, 1}) << true << 1.0;
    }
    void openSetConditionHolds() {
        QFETCH(const Maps2, maps);
        QFETCH(const bool, isExact);
        QFETCH(const double, dimension);
        const auto found = invariantsFor<2>(maps).openSet;
        QVERIFY(found);
        QCOMPARE(found->condition, OpenSetCondition::Holds);
        QCOMPARE(found->certainty == Certainty::Exact, isExact);
        QVERIFY(found->dimension && near(found->dimension->value, dimension, 1e-12));
        QCOMPARE(found->dimension->proof, HausdorffDimension::Proof::OpenSetCondition);
    }

    void solids() {
        const auto found = invariantsFor<3>(sponge()).openSet;
        QVERIFY(found && found->condition == OpenSetCondition::Holds);
        QVERIFY(near(found->dimension->value, std::log(20.0) / std::log(3.0), 1e-12));
        const auto tetrahedra = invariantsFor<3>(tetrahedron()).openSet;
        QVERIFY(tetrahedra && tetrahedra->condition == OpenSetCondition::Holds);
        QCOMPARE(tetrahedra->certainty, Certainty::Exact);
        QVERIFY(near(tetrahedra->dimension->value, 2, 1e-12));
    }

    // Ngai and Wang: 03 = 10 in base 3; the numbers of maps are 3, 8, 21, 55 …
    void digitsZeroOneThree() {
        const auto found = invariantsFor<2>(onALine(1. / 3, {0, 1, 3})).openSet;
        QVERIFY(found && found->condition == OpenSetCondition::Fails);
        QVERIFY(found->dimension && near(found->dimension->value, 0.8760357589718848, 1e-12));
        QCOMPARE(found->dimension->proof, HausdorffDimension::Proof::FiniteType);
        QCOMPARE(found->dimension->certainty, Certainty::ToRounding);
        // The same in base 4 with 04 = 10, which doubles hold: 3, 8, 21 once more.
        const Maps2 exact = onALine(.25, {0, 1, 4});
        const auto graph = graphOf<2>(exact);
        QVERIFY(graph && graph->overlap());
        QCOMPARE(graph->certainty(), Certainty::Exact);
        QVERIFY(exactWord<2>(exact, graph->overlap()->first) ==
                exactWord<2>(exact, graph->overlap()->second));
        QCOMPARE(countDifferent(exact, 2), std::size_t(8));
        QCOMPARE(countDifferent(exact, 4), std::size_t(55));
        QVERIFY(near(graph->growth()->most, (3 + std::sqrt(5.0)) / 2, 1e-12));
    }

    void goldenSets() {
        const auto gasket = graphOf<2>(goldenGasket());
        QVERIFY(gasket && gasket->overlap());
        QCOMPARE(gasket->certainty(), Certainty::ToRounding);
        QVERIFY(near(gasket->growth()->most, 2.532088886237956, 1e-12));
        const auto facts = invariantsFor<2>(goldenGasket()).openSet;
        QVERIFY(near(facts->dimension->value, 1.9306354508224262, 1e-12));
        const auto interval = invariantsFor<2>(onALine(golden, {0, 1})).openSet;
        QVERIFY(near(interval->dimension->value, 1, 1e-12));
    }

    // The pictures of numbers of maps by brute force.
    void growthOfRandomDigits() {
        Random random(3);
        for (int n = 0; n < 30; ++n) {
            std::set<int> digits{0};
            while (digits.size() < 3)
                digits.insert(int(random() % 8));
            const Maps2 maps = onALine(.25, {digits.begin(), digits.end()});
            const auto graph = graphOf<2>(maps);
            QVERIFY(graph);
            const double before = double(countDifferent(maps, 5)), after = double(countDifferent(maps, 6));
            const double growth = graph->growth()->most;
            QVERIFY2(std::abs(after / before - growth) < 0.05, qPrintable(QString::number(growth)));
            QCOMPARE(graph->overlap().has_value(), growth < 3);
        }
    }

    // A reflection across the line of the attractor changes no point of it: the pieces coincide.
    void reflectionsAcrossTheAttractor() {
        Maps2 maps = onALine(.25, {0, 1});
        maps.push_back(affineMap(.25, 0, 0, -.25, .25, 0));
        const auto found = invariantsFor<2>(maps).openSet;
        QVERIFY(found && found->condition == OpenSetCondition::Fails);
        QVERIFY(near(found->dimension->value, .5, 1e-12));
    }

    // Coefficients that are rounded up make Σ|det| exceed 1 by nothing that tells.
    void tilesByRounding() {
        const double third = .5, rise = std::sqrt(3.0) / 6;
        const auto turned = [](double a, double b, double e, double f) {
            return affineMap(a, -b, b, a, e, f);
        };
        const Maps2 terdragon{turned(third, rise, 0, 0), turned(0, -2 * rise, third, rise),
                              turned(third, rise, third, -rise)};
        for (const double scale : {1 - 0x1p-52, 1.0, 1 + 0x1p-52}) {
            Maps2 maps = terdragon;
            for (auto& map : maps)
                map.linear *= scale;
            const auto found = invariantsFor<2>(maps).openSet;
            QVERIFY(found && found->condition == OpenSetCondition::Holds);
            QCOMPARE(found->certainty, Certainty::ToRounding);
        }
    }

    void notOfFiniteType() {
        QVERIFY(!graphOf<2>(onALine(.4, {0, 1, std::numbers::e})));
        QVERIFY(!graphOf<2>(fern()));   // no similarities
        QVERIFY(!graphOf<2>(flower())); // two ratios
        const auto found = invariantsFor<2>(maple()).openSet;
        QVERIFY(found && found->condition == OpenSetCondition::Fails); // Σ|det| > 1
    }

    // What rounds to an overlap, and is none, is no exact one.
    void nearlyOverlapping() {
        const Maps2 maps = onALine(std::nextafter(.25, 1), {0, 1, 4});
        const auto graph = graphOf<2>(maps);
        QVERIFY(!graph || graph->certainty() == Certainty::ToRounding);
        const Maps2 apart = onALine(.25 + 1e-9, {0, 1, 4});
        const auto other = graphOf<2>(apart);
        QVERIFY(!other || !other->overlap());
    }

    // What differs by more than two units in the last place of each coefficient is different.
    void roundingIsAFewUlps() {
        constexpr bool isLong =
            std::numeric_limits<long double>::digits > std::numeric_limits<double>::digits;
        for (const double typed : {.618034, .61803398874988, .6180339887499}) {
            if (!isLong && std::abs(typed - golden) < 1e-12) continue;
            const Invariants found = invariantsFor<2>(towards(typed, {{0, 0}, {1, 0}}));
            QVERIFY(found.contacts->overlaps.empty());
            // Two of .618 fill more than a line: not by rounding.
            QCOMPARE(found.openSet->condition, OpenSetCondition::Fails);
            QCOMPARE(found.openSet->certainty, Certainty::Exact);
            QVERIFY(found.openSet->dimension && found.openSet->dimension->value == 1);
            QCOMPARE(found.openSet->dimension->proof, HausdorffDimension::Proof::Convex);
        }
        for (const double rounded : {golden, std::nextafter(golden, 0), std::nextafter(golden, 1)}) {
            const Invariants found = invariantsFor<2>(towards(rounded, {{0, 0}, {1, 0}}));
            QCOMPARE(found.openSet->condition, OpenSetCondition::Fails);
            QCOMPARE(found.openSet->certainty, Certainty::ToRounding);
            QVERIFY(near(found.openSet->dimension->value, 1, 1e-13));
        }
        for (const double gap : {0x1p-40, 0x1p-46, 0x1p-48}) {
            if (!isLong && gap < 0x1p-42) continue;
            const auto dust = invariantsFor<2>(onALine(.5 - gap, {0, 1})).contacts->connectedness;
            QVERIFY(dust != Connectedness::Connected && dust != Connectedness::ConnectedToRounding);
        }
    }

    // No walk goes on for ever, and what the maps are off by does not matter: proved, not to rounding.
    void dustOfNearlyHalf() {
        for (const double ratio : {.4999999999, .4999999, .49999999999}) {
            Maps2 maps;
            for (const double x : {0., 1.})
                for (const double y : {0., 1.})
                    maps.push_back(affineMap(ratio, 0, 0, ratio, x, y));
            const Invariants found = invariantsFor<2>(maps);
            QCOMPARE(found.contacts->separation, Separation::Strong);
            QCOMPARE(found.contacts->connectedness, Connectedness::Disconnected);
            QCOMPARE(found.openSet->condition, OpenSetCondition::Holds);
            QCOMPARE(found.openSet->certainty, Certainty::Exact);
        }
        // What touches or overlaps is never called disjoint.
        for (const double ratio : {.5, .5 + 1e-10, std::nextafter(.5, 1)}) {
            Maps2 maps;
            for (const double x : {0., 1.})
                for (const double y : {0., 1.})
                    maps.push_back(affineMap(ratio, 0, 0, ratio, x, y));
            QVERIFY(invariantsFor<2>(maps).contacts->separation != Separation::Strong);
        }
        // The rounded Koch curve is known to touch to rounding only, and may fall apart by it.
        const auto graph = graphOf<2>(koch());
        QVERIFY(graph && !graph->areApart(0, 1) && !graph->areApart(2, 3) && graph->areApart(0, 3));
        QVERIFY(graph->areApart(3, 0) && !graph->areApart(1, 1));
    }

    // More types of pieces than a matrix of bits has room for; counted in whole numbers elsewhere.
    void thousandsOfTypes() {
        const auto turned = [](double x, double y) { return affineMap(0, .5, -.5, 0, x, y); };
        const auto first = graphOf<2>(Maps2{turned(0, 0), turned(1, 0), turned(.5, -.5), turned(1, -2.5)});
        QVERIFY(first && first->overlap());
        const auto growth = first->growth();
        QVERIFY(growth && near((growth->least + growth->most) / 2, 3.71771505576, 1e-11));
        QVERIFY(growth->most - growth->least <= 1e-11 * growth->most);
        const auto half = [](double x, double y) { return affineMap(.5, 0, 0, .5, x, y); };
        const auto found =
            invariantsFor<2>(Maps2{half(0, 1), half(0, 1.5), half(1, 0), half(1, 1), half(2.5, 2)}).openSet;
        QVERIFY(found && found->dimension);
        QVERIFY(near(found->dimension->value, 1.9996105013, 1e-10));
        QCOMPARE(found->dimension->proof, HausdorffDimension::Proof::FiniteType);
    }

    void meetingPieces() {
        const auto dragon = invariantsFor<2>(heighway());
        QCOMPARE(dragon.contacts->connectedness, Connectedness::Connected);
        const auto dust = invariantsFor<2>(onALine(.25, {0, 2}));
        QCOMPARE(dust.contacts->connectedness, Connectedness::Disconnected);
        const auto graph = graphOf<2>(sierpinskiRight());
        QVERIFY(graph->meet(0, 1) && graph->meet(1, 2) && graph->neighbours() == 6);
    }

    void jointSpectralRadiusOfSimilitudes() {
        for (const Maps2& maps : {levy(), sierpinskiRight(), koch()}) {
            const auto radius = jointSpectralRadius<2>(maps, classify<2>(maps));
            QVERIFY(radius.most - radius.least <= 0x1p-49 * radius.most);
        }
        const Maps2 half = sierpinskiRight();
        QCOMPARE(jointSpectralRadius<2>(half, classify<2>(half)).least, .5);
        QCOMPARE(jointSpectralRadius<2>(half, classify<2>(half)).most, .5);
        for (const double tiny : {1e-160, 1e-200, 1e-310}) { // squares underflow
            const Maps2 maps{affineMap(tiny, 0, 0, tiny, 0, 0), affineMap(tiny, 0, 0, tiny, 1, 0)};
            const auto radius = jointSpectralRadius<2>(maps, classify<2>(maps));
            QVERIFY(radius.least <= tiny && radius.most >= tiny);
            QVERIFY(radius.least > .999 * tiny && radius.most < 1.001 * tiny);
        }
    }
};

BARYCAGE_TEST(NeighbourGraphTest);
#include "neighbour_graph_test.moc"
