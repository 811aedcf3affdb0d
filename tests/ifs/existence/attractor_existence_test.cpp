// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/existence/attractor_existence.h"
#include "ifs/existence/expansion.h"
#include "support/named_test.h"
#include "support/near.h"

#include <QtTest>

#include <Eigen/Geometry>

using namespace ifs;
using namespace canonical;

namespace {

using support::near;

// The three homeomorphic triangle maps and the middle one: corners on the sides at the given ratios.
Maps2 triangleFamily(double alpha, double beta, double gamma) {
    const Vector<2> A(0, 0), B(1, 0), C(0, 1);
    const Vector<2> c = A + alpha * (B - A), a = B + beta * (C - B), b = C + gamma * (A - C);
    const auto onto = [](const Vector<2>& p, const Vector<2>& q, const Vector<2>& r) {
        return affineMap(q.x() - p.x(), r.x() - p.x(), q.y() - p.y(), r.y() - p.y(), p.x(), p.y());
    };
    return {onto(c, a, B), onto(C, a, b), onto(c, A, b), onto(c, a, b)};
}

template <int Dim> double norm(const std::vector<AffineMap<Dim>>& maps, const std::vector<int>& address) {
    Matrix<Dim> product = Matrix<Dim>::Identity();
    for (const int symbol : address)
        product *= maps[std::size_t(symbol)].linear;
    return spectralNorm<Dim>(product);
}

template <int Dim> void verdictSurvivesBaking() {
    Random random(1);
    for (int n = 0; n < 500; ++n) {
        const auto maps = randomContractions<Dim>(random, 2 + int(random() % 3), 0.6);
        const AffineMap<Dim> t{randomWellConditioned<Dim>(random, 6), randomVector<Dim>(random)};
        const auto baked = mapsOf(*conjugate(t, canonical::system<Dim>(maps)));
        const Existence existence = classify<Dim>(baked);
        QVERIFY(existence.verdict == Verdict::Hyperbolic ||
                existence.verdict == Verdict::EventuallyContractive);
        QVERIFY(existence.contractivity < 1);
        QVERIFY(existence.normEquivalence >= 1);
        QVERIFY(near(std::pow(norm<Dim>(baked, existence.witness), 1.0 / existence.wordLength),
                     existence.contractivity, 1e-9));
    }
}

// Rounded coefficients make of a rotation one that keeps lengths or shrinks them by an ulp, which exact
// arithmetic tells.
template <int Dim> bool isRotationDecided(const std::vector<AffineMap<Dim>>& maps) {
    const Existence existence = classify<Dim>(maps);
    return exactExpansion<Dim>(maps, {0}) == Expansion::Yes ? existence.verdict == Verdict::None
                                                            : existence.exists();
}

// Leaning matrices with ρ = 1 − 1e-4 … 1 − 1e-13 but for rounding.
template <int Dim> void decideCommonMatrices() {
    Random random(17);
    for (int n = 0; n < 60; ++n) {
        Matrix<Dim> form = Matrix<Dim>::Zero(), basis = Matrix<Dim>::Identity();
        for (int k = 0; k < Dim; ++k)
            form(k, k) = k == 0 ? 1 - std::pow(10, uniform(random, -13, -4)) : uniform(random, -.9, .9);
        for (int k = 1; k < Dim; ++k)
            basis.col(k) += std::pow(10, uniform(random, 0, 2)) * randomVector<Dim>(random);
        const AffineMap<Dim> map{basis * form * basis.inverse(), randomVector<Dim>(random)};
        const std::vector<AffineMap<Dim>> maps{map, {-map.linear, randomVector<Dim>(random)}};
        const bool expands = exactExpansion<Dim>(maps, {0}) == Expansion::Yes;
        for (const std::span<const AffineMap<Dim>> some : {std::span(maps).first(1), std::span(maps)}) {
            const Existence existence = classify<Dim>(some);
            QVERIFY2(expands == (existence.verdict == Verdict::None) &&
                         existence.verdict != Verdict::Undecided,
                     qPrintable(QStringLiteral("matrix %1").arg(n)));
        }
        const Existence one = classify<Dim>(std::span(maps).first(1));
        if (expands || one.wordLength != 1) continue;
        QVERIFY(one.contractivity < 1);
        const double stretch = 1 + (1 - one.contractivity) * (1 - 1e-3); // by less than 1/γ
        const std::vector<AffineMap<Dim>> stretched{map,
                                                    {stretch * Matrix<Dim>::Identity(), map.translation}};
        QVERIFY(exactExpansion<Dim>(stretched, {0, 1}) == Expansion::No);
        Matrix<Dim> power = map.linear;
        for (double length = 1; length < 1e9; length *= 2, power *= power.eval())
            QVERIFY(spectralNorm<Dim>(power) <=
                    one.normEquivalence * std::pow(one.contractivity, length) * (1 + 1e-6));
    }
}

} // namespace

class AttractorExistenceTest : public QObject {
    Q_OBJECT

private slots:
    void hyperbolic() {
        const Existence existence = classify<2>(maple());
        QCOMPARE(existence.verdict, Verdict::Hyperbolic);
        QVERIFY(near(existence.contractivity, 0.723195530540, 1e-12));
        QCOMPARE(existence.witness, std::vector<int>{3});
        QCOMPARE(existence.normEquivalence, 1.0);
        QCOMPARE(classify<3>(fern3()).verdict, Verdict::Hyperbolic);
    }

    void eventuallyContractive() {
        const Existence existence = classify<2>(eventual());
        QCOMPARE(existence.verdict, Verdict::EventuallyContractive);
        QCOMPARE(existence.wordLength, 5);
        QVERIFY(near(existence.contractivity, 0.958037596608, 1e-9));
        QVERIFY(near(existence.normEquivalence, 2.212569920566, 1e-9));
        QVERIFY(near(norm<2>(eventual(), existence.witness), std::pow(existence.contractivity, 5), 1e-12));
    }

    void expandingWord() {
        Matrix<2> shear;
        shear << .5, 2, 0, .5;
        const Maps2 maps{{shear, {0, 0}}, {shear.transpose(), {0, 0}}};
        const Existence existence = classify<2>(maps);
        QCOMPARE(existence.verdict, Verdict::None);
        QCOMPARE(existence.witness.size(), std::size_t(2));
        QVERIFY(existence.witness[0] != existence.witness[1]);
        QVERIFY(near(existence.contractivity, 2.118033988750, 1e-9));
    }

    void triangles() {
        const Maps2 maps = triangleFamily(.65, .3, .4);
        const double norms[] = {0.361315, 1.032709, 1.030410, 0.901503};
        for (std::size_t i = 0; i < 4; ++i)
            QVERIFY(near(spectralNorm<2>(maps[i].linear), norms[i], 1e-6));
        const Existence existence = classify<2>(maps);
        QCOMPARE(existence.verdict, Verdict::EventuallyContractive);
        QCOMPARE(existence.wordLength, 2);
        QVERIFY(near(existence.contractivity, 0.897529, 1e-6));
    }

    void bakedFlower() {
        const auto baked = conjugate(affineMap(1, 3, 0, 1, 0, 0), canonical::system<2>(flower()));
        const Existence existence = classify<2>(mapsOf(*baked));
        QCOMPARE(existence.verdict, Verdict::EventuallyContractive);
        QCOMPARE(existence.wordLength, 4);
        QVERIFY(near(existence.contractivity, 0.993468, 1e-6));
    }

    // Too many maps to try words of length 2: only a norm that fits the maps tells.
    void manyShearedMaps() {
        Random random(9);
        IteratedFunctionSystem<2> code;
        for (int i = 0; i < 400; ++i)
            append(code, similarity(uniform(random, .1, .9), uniform(random, 0, 6), uniform(random),
                                    uniform(random)));
        const auto baked = conjugate(affineMap(1, 9, 0, 1, 0, 0), code);
        const Existence existence = classify<2>(mapsOf(*baked));
        QCOMPARE(existence.verdict, Verdict::EventuallyContractive);
        QVERIFY(existence.contractivity < 0.91);
        // √cond(P) is the condition of the lean: (9 + √85)²/4 = 82.99.
        QVERIFY(near(existence.normEquivalence, 82.988, 0.01));
    }

    void verdictSurvivesBaking2() { verdictSurvivesBaking<2>(); }
    void verdictSurvivesBaking3() { verdictSurvivesBaking<3>(); }

    void emptyAndExtreme() {
        QCOMPARE(classify<2>({}).verdict, Verdict::Empty);
        for (const double bad : {quietNaN, infinity}) {
            const Maps2 inLinear{affineMap(bad, 0, 0, .5, 0, 0)},
                inTranslation{affineMap(.5, 0, 0, .5, bad, 0)};
            QCOMPARE(classify<2>(inLinear).verdict, Verdict::Undecided);
            QCOMPARE(classify<2>(inTranslation).verdict, Verdict::Undecided);
        }
        const Maps2 nilpotent{affineMap(0, 1e200, 0, 0, 1, 1)};
        QCOMPARE(classify<2>(nilpotent).verdict, Verdict::EventuallyContractive);
        QCOMPARE(classify<2>(nilpotent).contractivity, 0.0);
        const Existence vanishing =
            classify<2>(Maps2{affineMap(0, 5, 0, 0, 1, 1), affineMap(0, 5, 0, 0, 0, 0)});
        QCOMPARE(vanishing.contractivity, 0.0);
        QVERIFY(vanishing.normEquivalence >= 5 && std::isfinite(vanishing.normEquivalence));
        const Maps2 huge{affineMap(1e300, 1e300, -1e300, 1e300, 0, 0)};
        QCOMPARE(classify<2>(huge).verdict, Verdict::None);
        const Maps2 constant{affineMap(0, 0, 0, 0, 1, 2)};
        QCOMPARE(classify<2>(constant).verdict, Verdict::Hyperbolic);
        QCOMPARE(classify<2>(constant).contractivity, 0.0);
    }

    void rotationsAreDecided() {
        Random random(2);
        for (int n = 0; n < 1000; ++n) {
            const Maps2 maps{similarity(1, uniform(random, 0, 6), 1, 2)};
            QVERIFY(isRotationDecided<2>(maps));
        }
        QCOMPARE(classify<2>(Maps2{affineMap(0, -1, 1, 0, 1, 2)}).verdict, Verdict::None);
        QCOMPARE(classify<2>(Maps2{affineMap(.6, -.8, .8, .6, 1, 2)}).verdict, Verdict::None);
    }

    // However slowly: as long as every norm is less than 1, the maps contract.
    void slowContractions() {
        for (const double rest : {1e-9, 1e-12, 1e-15}) {
            const Existence existence =
                classify<2>(Maps2{affineMap(-1 + rest, 0, 0, .5, 1, 0), affineMap(-.5, 0, 0, .5, 0, 0)});
            QCOMPARE(existence.verdict, Verdict::Hyperbolic);
            QCOMPARE(existence.contractivity, 1 - rest);
            Maps3 inSpace = fern3();
            inSpace[0].linear(1, 1) = 1 - 16 * rest;
            QCOMPARE(classify<3>(inSpace).verdict, Verdict::Hyperbolic);
        }
        const Maps2 eventually{affineMap(1 - 1e-12, 3, 0, .5, 0, 0)};
        QVERIFY(classify<2>(eventually).verdict != Verdict::None);
    }

    // Along a flag that all of them keep, these are as short as their diagonals; no search leads there. One
    // map is a flag of its own.
    void flagsAreFound() {
        const auto map = [](std::initializer_list<double> entries) {
            AffineMap<3> result;
            result.linear = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(entries.begin());
            return result;
        };
        const std::vector<AffineMap<3>> one{
            map({24.272754553835124, 23.930793100849513, 3.8947724409928517, -23.50678246672049,
                 -23.18696997674112, -3.687271741551109, -1.6089668755841986, -1.587237417683673,
                 -0.24790140966439603})};
        const std::vector<AffineMap<3>> three{
            map({0.5572661655828814, 0.8312355541505789, -0.05501487180212977, -0.09782093754833618,
                 0.39237317014857737, 0.11710835691155458, 0.4413347147554258, -0.003050575311713849,
                 -0.12795261156895288}),
            map({1.2693256499926804, 0.5531572334233523, -0.9068279565020141, -0.38421971518141806,
                 0.8400140149082894, 0.5386207238997007, 1.4039543479021057, 0.6808406188470664,
                 -1.204066112335775}),
            map({0.8023500291210237, -0.9513996302509914, -0.22976841736365547, 0.24265155742947297,
                 -0.3374810870055035, -0.3919956881435448, -0.25145079854255437, -0.9546481066345569,
                 0.7034885225995458})};
        for (const auto& maps : {one, three}) {
            const Existence existence = classify<3>(maps);
            QCOMPARE(existence.verdict, Verdict::EventuallyContractive);
            QVERIFY(existence.contractivity > 0.97 && existence.contractivity < 0.99);
        }
        // By 3·10⁻⁵ a step, along directions 10 times as long as wide.
        const std::vector<AffineMap<2>> slow{affineMap(1.145293958287127, -0.43914804425768905,
                                                       0.29686993619262564, 0.10287175121705514, 0.12, 0.25)};
        QCOMPARE(classify<2>(slow).verdict, Verdict::EventuallyContractive);
    }

    // Near ρ = 1 too, of one map, and of two that differ by a sign.
    void commonMatricesAreDecided() {
        decideCommonMatrices<2>();
        decideCommonMatrices<3>();
    }

    // What expands by no more than rounding can cost is not said to expand.
    void noneIsProved() {
        for (const double rest : {0.0, 1e-12}) {
            for (const Maps2& maps :
                 {Maps2{affineMap(1 + rest, 5, 0, .5, 0, 0)}, Maps2{affineMap(1 + rest, 1e6, 0, 1, 0, 0)},
                  Maps2{affineMap(2, 0, 0, .25, 0, 0), affineMap(.5 + rest, 0, 0, 4, 0, 0)}}) {
                const Existence existence = classify<2>(maps);
                QCOMPARE(existence.verdict, Verdict::None);
                QVERIFY(existence.contractivity >= 1);
            }
            Maps3 inSpace = fern3();
            inSpace[0].linear(1, 1) = 1 + rest;
            QCOMPARE(classify<3>(inSpace).verdict, Verdict::None);
        }
        // A rotation by 0.99999 that leans by 1e8: its coefficients cancel to what rounding leaves.
        const AffineMap<2> lean = affineMap(1, 1e8, 0, 1, 0, 0);
        Random random(4);
        for (int n = 0; n < 200; ++n) {
            const auto leaning = conjugate(lean, similarity(1 - 1e-5, uniform(random, 0, 6), 1, 2));
            QVERIFY(classify<2>(Maps2{*leaning}).verdict != Verdict::None ||
                    exactExpansion<2>(Maps2{*leaning}, {0}) == Expansion::Yes);
        }
    }

    // The segment from (0, 0) to (0, 2) is the union of its images, but draws no other point to it.
    void anInvariantSetIsNotEnough() {
        const Existence existence =
            classify<2>(Maps2{affineMap(2, 0, 0, .5, 0, 0), affineMap(2, 0, 0, .5, 0, 1)});
        QCOMPARE(existence.verdict, Verdict::None);
        QCOMPARE(existence.witness.size(), std::size_t(1));
        QCOMPARE(existence.contractivity, 2.0);
    }

    void rotationsInSpaceAreDecided() {
        Random random(5);
        for (int n = 0; n < 1000; ++n) {
            const Matrix<3> turn =
                Eigen::Quaterniond(uniform(random), uniform(random), uniform(random), uniform(random))
                    .normalized()
                    .matrix();
            const Maps3 maps{map3(turn, randomVector<3>(random))};
            QVERIFY(isRotationDecided<3>(maps));
        }
    }

    void workIsBounded() {
        const Existence undecided = classify<2>(eventual(), 0);
        QCOMPARE(undecided.verdict, Verdict::Undecided);
        QVERIFY(near(undecided.contractivity, 2.118033988750, 1e-9));
        QCOMPARE(classify<2>(eventual(), 59).wordLength, 1); // 4 + 8 + 16 + 32 products would reach length 5
        QCOMPARE(classify<2>(eventual(), 60).wordLength, 5);
        const Maps2 many(10'000, affineMap(.5, 2, 0, .5, 0, 0));
        const Verdict verdict = classify<2>(many).verdict;
        QVERIFY(verdict == Verdict::Undecided || verdict == Verdict::EventuallyContractive);
    }
};

BARYCAGE_TEST(AttractorExistenceTest);
#include "attractor_existence_test.moc"
