// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/system/iterated_function_system.h"
#include "support/named_test.h"
#include "support/near.h"

#include <QtTest>

#include <Eigen/LU>

#include <numeric>

using namespace ifs;
using namespace canonical;
using support::near;

namespace {

double sum(const std::vector<double>& p) {
    return std::accumulate(p.begin(), p.end(), 0.0);
}

template <int Dim> void bakeAndUnbake() {
    Random random(11);
    for (int n = 0; n < 1000; ++n) {
        const auto code = canonical::system<Dim>(randomContractions<Dim>(random, 3));
        const AffineMap<Dim> t{randomWellConditioned<Dim>(random), randomVector<Dim>(random, 3)};
        const auto there = conjugate(t, code);
        const auto back = conjugate(*inverse(t), *there);
        const auto weights = probabilities(code), bakedWeights = probabilities(*there);
        QVERIFY(near(weights, bakedWeights, 1e-12));
        for (std::size_t i = 0; i < 3; ++i) {
            QVERIFY((back->maps[i].map.linear - code.maps[i].map.linear).norm() <= 1e-13);
            QVERIFY((back->maps[i].map.translation - code.maps[i].map.translation).norm() <= 1e-12);
            QCOMPARE(there->maps[i].id, code.maps[i].id);
            QCOMPARE(there->maps[i].weight, code.maps[i].weight);
        }
    }
}

} // namespace

class IteratedFunctionSystemTest : public QObject {
    Q_OBJECT

private slots:
    void determinantRule() {
        QVERIFY(near(determinantWeights<2>(fern()),
                     {0.00990099010, 0.76537919620, 0.10971738791, 0.11500242580}, 5e-11));
        QVERIFY(near(determinantWeights<2>(maple()), {4. / 157, 1891. / 10205, 798. / 2041, 4064. / 10205},
                     1e-15));
        const std::vector<AffineMap<2>> points(3, affineMap(0, 0, 0, 0, 1, 2));
        QVERIFY(near(determinantWeights<2>(points), {1. / 3, 1. / 3, 1. / 3}, 1e-16));
        QVERIFY(determinantWeights<2>({}).empty());
        // Singular but for the rounding of their decimals.
        const Maps2 flat{affineMap(.3, .6, .1, .2, 0, 0), affineMap(.7, .21, .1, .03, 1, 0),
                         affineMap(.2, .6, .1, .3, 0, 1)};
        QCOMPARE(determinantWeights<2>(flat), equalWeights(3));
        QCOMPARE(determinant<2>(flat[1].linear), 0.0);
        Matrix<3> folded;
        folded << .1, .2, .3, .4, .5, .6, .7, .8, .9;
        QVERIFY(folded.determinant() != 0);
        QCOMPARE(determinantWeights<3>(Maps3{map3(folded, {0, 0, 0}), map3(folded.transpose(), {1, 0, 0})}),
                 equalWeights(2));
        // What is known, however small, counts.
        QCOMPARE(determinant<2>(affineMap(1, 1, 1, 1 + 0x1p-40, 0, 0).linear), 0x1p-40);
        QCOMPARE(determinant<2>(affineMap(1e-150, 0, 0, 1e-150, 0, 0).linear), 1e-300);
        QCOMPARE(determinant<2>(affineMap(1e200, 1, 1, 1e200, 0, 0).linear), infinity);
    }

    void sharesThatSumToOneStay() {
        for (const std::vector<double>& p : {std::vector<double>{.9, .1}, {.7, .2, .1}, {.01, .85, .07, .07}})
            QCOMPARE(shares(p), p);
    }

    // max(q/Σq, δ), and these are shares again.
    void noShareIsBelowTheFloor() {
        QVERIFY(near(shares({8, 1, 1, 0}, .2), {.8 / 1.4, .2 / 1.4, .2 / 1.4, .2 / 1.4}, 1e-15));
        QVERIFY(near(
            determinantWeights<2>(Maps2{affineMap(.5, 0, 0, .5, 0, 0), affineMap(.5, 0, 0, 0, 1, 0)}, .01),
            {1 / 1.01, .01 / 1.01}, 1e-15));
    }

    void sharesSurviveAnyMasses() {
        QVERIFY(near(shares({1e308, 1e308}), {.5, .5}, 0));
        QVERIFY(near(shares({1e-320, 3e-320}), {.25, .75}, 1e-3));
        QVERIFY(near(shares({quietNaN, -1, 2}), {0, 0, 1}, 0));
        QVERIFY(near(shares({infinity, 0}), {.5, .5}, 0));
        QVERIFY(shares({}).empty());
        Random random(3);
        for (int n = 0; n < 1000; ++n) {
            std::vector<double> masses(1 + random() % 50);
            for (double& mass : masses)
                mass = std::pow(10, uniform(random, -300, 300));
            const auto p = shares(masses, 0.01);
            QVERIFY(std::abs(sum(p) - 1) <= 1e-15 * double(p.size()));
            QVERIFY(std::ranges::min(p) > 0);
        }
    }

    void weightsAsGiven() {
        auto code = canonical::system<2>(fern(), {2, 6, 0, -1});
        QVERIFY(near(probabilities(code), {.25, .75, 0, 0}, 0));
        code.maps[0].enabled = false;
        QVERIFY(near(probabilities(code), {0, 1, 0, 0}, 0));
        const auto active = activeMaps(code);
        QCOMPARE(active.index, std::vector<std::size_t>{1});
        QCOMPARE(active.maps.front(), fern()[1]);
        QCOMPARE(active.probabilities, std::vector<double>{1});
    }

    // Whether a map takes part does not hang on how large the weights of others are.
    void noShareIsNothing() {
        auto code = canonical::system<2>(fern(), {1e-300, 3e38, 1e-310, 3e38});
        const auto active = activeMaps(code);
        QCOMPARE(active.index.size(), std::size_t(4));
        QVERIFY(std::ranges::min(active.probabilities) > 0);
        QCOMPARE(probabilities(code), active.probabilities);
        QCOMPARE(sum(active.probabilities), 1.0);
    }

    void oneMissingWeightCallsForTheDeterminantRule() {
        auto code = canonical::system<2>(fern(), {1, 1, 1, 1});
        code.maps[2].weight.reset();
        QCOMPARE(probabilities(code), determinantWeights<2>(fern()));
        code.maps[3].enabled = false;
        const auto p = probabilities(code);
        QCOMPARE(p[3], 0.0);
        QVERIFY(std::abs(sum(p) - 1) < 1e-15);
    }

    void everythingOff() {
        auto code = canonical::system<2>(fern());
        for (auto& map : code.maps)
            map.enabled = false;
        QVERIFY(near(probabilities(code), {0, 0, 0, 0}, 0));
        QVERIFY(activeMaps(code).maps.empty());
        QVERIFY(probabilities(IteratedFunctionSystem<2>{}).empty());
    }

    void idsAreFresh() {
        IteratedFunctionSystem<2> code;
        const MapId first = append(code, AffineMap<2>{}), second = append(code, AffineMap<2>{});
        QVERIFY(first != MapId::None && second != MapId::None && first != second);
        code.maps.erase(code.maps.begin());
        code.maps.front().id = MapId{0xFFFFFFFFu};
        const MapId third = append(code, AffineMap<2>{});
        QVERIFY(third != MapId::None && third != MapId{0xFFFFFFFFu});
    }

    void conjugateByTranslation() {
        AffineMap<2> shift;
        shift.translation << 1, 2;
        const auto baked = conjugate(shift, canonical::system<2>(sierpinskiRight()));
        QCOMPARE(baked->maps[0].map, affineMap(.5, 0, 0, .5, .5, 1));
    }

    void conjugateByShear() {
        const auto baked = conjugate(affineMap(1, 3, 0, 1, 0, 0), canonical::system<2>(flower()));
        Matrix<2> expected;
        expected << -0.43, 3.0, -0.3, 1.37;
        QVERIFY((baked->maps[0].map.linear - expected).norm() < 1e-14);
        QVERIFY(std::abs(spectralNorm<2>(baked->maps[0].map.linear) - 3.338132067560) < 1e-12);
        QVERIFY(std::abs(spectralNorm<2>(baked->maps[1].map.linear) - 3.234075333) < 2e-9);
        QVERIFY(std::abs(spectralRadius<2>(baked->maps[0].map.linear) - 0.557584074378) < 1e-12);
    }

    void conjugateRefusesToLoseDigits() {
        const auto code = canonical::system<2>(flower());
        QVERIFY(!conjugate(affineMap(1, 0, 0, 0, 0, 0), code));
        QVERIFY(!conjugate(affineMap(1, 0, 0, 0.9e-6, 0, 0), code));
        QVERIFY(conjugate(affineMap(1, 0, 0, 1.1e-6, 0, 0), code));
        QVERIFY(!conjugate(affineMap(quietNaN, 0, 0, 1, 0, 0), code));
    }

    void bakeAndUnbake2() { bakeAndUnbake<2>(); }
    void bakeAndUnbake3() { bakeAndUnbake<3>(); }

    void bakingCommutesWithTheOrbit() {
        Random random(5);
        const AffineMap<2> t{randomWellConditioned<2>(random), {3, -4}};
        const auto baked = mapsOf(*conjugate(t, canonical::system<2>(maple())));
        Vector<2> x = *fixedPoint(maple()[0]), y = t(x);
        for (int n = 0; n < 1000; ++n) {
            const std::size_t i = random() % 4;
            x = maple()[i](x);
            y = baked[i](y);
            QVERIFY((y - t(x)).norm() <= 1e-11);
        }
    }
};

BARYCAGE_TEST(IteratedFunctionSystemTest);
#include "iterated_function_system_test.moc"
