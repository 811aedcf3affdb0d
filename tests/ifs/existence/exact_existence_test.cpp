// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/existence/attractor_existence.h"
#include "ifs/existence/conditioning.h"
#include "ifs/existence/exact_contraction.h"
#include "ifs/existence/expansion.h"
#include "ifs/extent/support_function.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>
#include <limits>

using namespace ifs;
using namespace canonical;

namespace {

bool exists(const Existence& existence) {
    return existence.exists();
}

Matrix<3> matrix3(std::initializer_list<double> rows) {
    Matrix<3> result;
    int k = 0;
    for (const double entry : rows) {
        result(k / 3, k % 3) = entry;
        ++k;
    }
    return result;
}

// 2¹⁰⁰ times an integer matrix whose third power vanishes.
Matrix<3> hugeNilpotent() {
    return std::ldexp(1, 100) * matrix3({-2, 0, -2, -2, -1, -3, 2, 1, 3});
}

// A² = 2^(2k)·I/4, exactly: a square of differences of numbers that are 2³⁰ times as large.
Matrix<2> cancelling(double scale = 1) {
    Matrix<2> result;
    result << 1629810176.25, -1629810175.75, 1629810176.75, -1629810176.25;
    return scale * result;
}

// With eigenvalues near 1, and coefficients up to 2³⁰.
Matrix<2> leaning(Random& random) {
    const double lean = std::ldexp(uniform(random), int(random() % 30));
    Matrix<2> basis, diagonal = Matrix<2>::Zero();
    basis << 1, lean, uniform(random), 1 + lean * uniform(random);
    diagonal.diagonal() << 1 + std::ldexp(uniform(random), -int(random() % 56)), uniform(random);
    return basis * diagonal * basis.inverse();
}

// 1 less a few units in its last place.
double nearlyOne(Random& random) {
    return 1 - std::ldexp(double(1 + random() % 4), -53);
}

// Coefficients that are multiples of 2⁻¹², so that products of a few of them are exact.
double shortNumber(Random& random, double size = 1) {
    return std::round(size * uniform(random) * 4096) / 4096;
}

// Whether no word of up to six maps has ρ ≥ 1, without rounding.
template <int Dim> bool areShortWordsBelowOne(const std::vector<AffineMap<Dim>>& maps) {
    std::vector<std::vector<int>> words{{}};
    for (std::size_t k = 0; k < words.size() && words[k].size() < 6; ++k)
        for (int i = 0; i < int(maps.size()); ++i) {
            words.push_back(words[k]);
            words.back().push_back(i);
            if (exactExpansion<Dim>(maps, words.back()) == Expansion::Yes) return false;
        }
    return true;
}

// Families whose slowest map shrinks by a few units in the last place. Whether there is an attractor depends
// on the rounding of each.
enum class Slow { Similarities, Triangular, AcrossTheAxes, CommonDirection, Blocks };

Maps2 slowMaps(Slow kind, Random& random) {
    const double slow = nearlyOne(random), angle = 4 * uniform(random);
    const double small = shortNumber(random, .5), other = shortNumber(random, .5);
    Matrix<2> first, second;
    switch (kind) {
    case Slow::Similarities:
        first << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
        first *= slow;
        second = small * first;
        break;
    case Slow::Triangular:
        first << slow, shortNumber(random, 8), 0, small;
        second << other, shortNumber(random, 8), 0, -nearlyOne(random);
        break;
    case Slow::AcrossTheAxes:
        first << 0, slow, slow, 0;
        second << 0, small, 1, 0;
        break;
    default: {
        // Rows with one sum: (1, 1) is a direction that both maps keep. No difference is rounded.
        const double share = random() % 2 == 0 ? slow : slow / 2, a = std::abs(small), b = std::abs(other);
        first << slow - a, a, slow - b, b;
        second << share - b, b, a, share - a;
    }
    }
    return {{first, {1, 0}}, {second, {0, 1}}};
}

Maps3 slowSolids(Slow kind, Random& random) {
    Maps3 result;
    const Maps2 flat = slowMaps(kind == Slow::Blocks ? Slow::Similarities : Slow::Triangular, random);
    for (const AffineMap<2>& map : flat) {
        Matrix<3> linear = Matrix<3>::Zero();
        linear.topLeftCorner<2, 2>() = map.linear;
        linear(0, 2) = shortNumber(random, 8);
        linear(1, 2) = shortNumber(random, 8);
        linear(2, 2) = nearlyOne(random);
        result.push_back({linear, {1, 0, 0}});
    }
    return result;
}

} // namespace

// Systems on which numbers overflow, or cancel to less than their rounding. All of them are decided by what
// is known of them without rounding.
class ExactExistenceTest : public QObject {
    Q_OBJECT

private slots:
    // A block of two axes is decided by any norm, not only by the rules in exact arithmetic.
    void blocksAreDecidedByAnyNorm() {
        const Maps3 maps{
            {matrix3(
                 {-1.17578125, 0, -.78125, 12058624, .9999999999999964, -4718592, 1.3515625, 0, 1.3203125}),
             {1, 0, 0}},
            {matrix3({.32421875, 0, .6171875, 1572864, .875, -54272, .96484375, 0, .0859375}), {1, 1, 1}}};
        QVERIFY(classify<3>(maps).exists());
    }

    // A sign is known of a finite number only.
    void overflowProvesNothing() {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        for (const double scale : {1e60, 1e110, 1e160, 1e307}) {
            const Matrix<3> nilpotent = scale * matrix3({-2, 0, -2, -2, -1, -3, 2, 1, 3}) / 4;
            QVERIFY(expansion<3>(nilpotent, 1e-3 * scale) == Expansion::Unknown);
            const Matrix<3> next = nilpotent + scale * 1e-15 * Matrix<3>::Identity();
            QVERIFY(expansion<3>(next, 1e-3 * scale) == Expansion::Unknown);
            Matrix<2> flat;
            flat << scale, -scale, scale, -scale;
            QVERIFY(expansion<2>(flat, 1e-3 * scale) == Expansion::Unknown);
        }
        QVERIFY(expansion<3>(Matrix<3>::Identity(), infinity) == Expansion::Unknown);
        QVERIFY(expansion<2>(infinity * Matrix<2>::Ones(), infinity) == Expansion::Unknown);
        QVERIFY(expansion<3>(infinity * Matrix<3>::Ones(), 0) == Expansion::Unknown);
        QVERIFY(expansion<2>(Matrix<2>::Identity(), std::nan("")) == Expansion::Unknown);
    }

    void hugeNilpotentsDoNotExpand() {
        const Maps3 maps{map3(hugeNilpotent(), {1, 0, 0}), map3(.6 * Matrix<3>::Identity(), {0, 1, 0})};
        QVERIFY(exists(classify<3>(maps)));
        QVERIFY(!exists(classify<3>(Maps3{maps[0], map3(Matrix<3>::Identity(), {0, 1, 0})})));
        for (const int exponent : {-600, -100, 0, 40, 200, 300, 400, 600, 800, 1000})
            for (const double ratio : {.6, .999, -.75}) {
                const Matrix<3> nilpotent = std::ldexp(1, exponent - 100) * hugeNilpotent();
                const Maps3 scaled{map3(nilpotent, {1, 0, 0}),
                                   map3(ratio * Matrix<3>::Identity(), {0, 1, 0})};
                QVERIFY(classify<3>(scaled).verdict != Verdict::None);
                Matrix<2> flat;
                flat << 6, -4, 9, -6;
                flat *= std::ldexp(1, exponent);
                QVERIFY(classify<2>(Maps2{{flat, {1, 0}}, {ratio * Matrix<2>::Identity(), {0, 1}}}).verdict !=
                        Verdict::None);
                const double least = jointSpectralRadius<3>(scaled, Existence{}).least;
                QVERIFY2(least <= std::abs(ratio), qPrintable(QString::number(least)));
            }
    }

    void powersThatOverflow() {
        const Maps3 maps{map3(matrix3({-116337.67798311505, 2908.4169495908177, 58168.33899181635,
                                       34901.003395089814, -0.9999994823501344, -17450.501697544907,
                                       -232673.3559672654, 5816.833899181635, 116335.67798415036}),
                              {1, 0, 0})};
        QCOMPARE(exactExpansion<3>(maps, {0}), Expansion::No);
        QVERIFY(exists(classify<3>(maps)));
    }

    // Both ends, of matrices whose coefficients are all but equal to their rounding.
    void jointSpectralRadiusOfCancellingMaps() {
        for (const double scale : {1.0, 1.5, 0x1p-8, 0x1p10}) {
            const Maps2 maps{{cancelling(scale), {1, 0}}};
            const JointSpectralRadius radius = jointSpectralRadius<2>(maps, classify<2>(maps));
            QVERIFY2(radius.least <= scale / 2 && radius.most >= scale / 2,
                     qPrintable(QStringLiteral("%1 %2").arg(radius.least).arg(radius.most)));
        }
    }

    // Products that underflow are not nothing: what follows may be as large as they are small.
    void underflowProvesNothing() {
        const double tiny = 0x1p-700, huge = 0x1p1000;
        Matrix<2> up, down;
        up << 0, huge, 0, 0;
        down << 0, 0, tiny, 0;
        const Maps2 expanding{{up, {1, 0}}, {down, {0, 1}}}; // the product of both has ρ = 2³⁰⁰
        QVERIFY(!exists(classify<2>(expanding)));
        const Matrix<2> small = 0x1p-560 * Matrix<2>::Identity();
        QVERIFY(exists(classify<2>(Maps2{{small, {1, 0}}, {0x1p-600 * Matrix<2>::Identity(), {0, 1}}})));
        const Existence order =
            classify<2>(Maps2{{0x1p-600 * Matrix<2>::Identity(), {0, 1}}, {small, {1, 0}}});
        QCOMPARE(order.contractivity, 0x1p-560);
    }

    // Coordinates in which a map is no finite number prove nothing.
    void coordinatesThatOverflow() {
        const Maps2 maps{{.5 * Matrix<2>::Identity(), {1e308, 0}}, {.25 * Matrix<2>::Identity(), {0, 1}}};
        const auto seen = seenFrom<2>({0x1p-100 * Matrix<2>::Identity(), {0, 0}}, maps);
        QVERIFY(!seen || (isFinite(seen->maps[0]) && std::isfinite(seen->rounding(1))));
    }

    // By the exact signs alone, however near ρ is to 1 and however much the coefficients cancel.
    void singleMapsAreDecided() {
        QVERIFY(exists(classify<2>(Maps2{{cancelling(), {1, 0}}})));
        QCOMPARE(classify<2>(Maps2{{2 * cancelling(), {1, 0}}}).verdict, Verdict::None);
        QCOMPARE(classify<2>(Maps2{{2 * cancelling(), {1, 0}}, {-2 * cancelling(), {0, 1}}}).verdict,
                 Verdict::None);
        QVERIFY(exists(classify<2>(Maps2{affineMap(-0.9616878261478827, -0.4770864654484555,
                                                   -0.062416917643708686, -0.2227466199707716, 1, 0)})));
        // The radius of the witness is that of the coefficients as they are.
        QCOMPARE(classify<2>(Maps2{{2 * cancelling(), {1, 0}}}).contractivity, 1.0);
        QCOMPARE(classify<2>(Maps2{{8 * cancelling(), {1, 0}}}).contractivity, 4.0);
        const double huge = 0x1p60; // trace and determinant are those of the diagonal
        QCOMPARE(classify<3>(Maps3{map3(matrix3({2, huge, huge, 0, .5, huge, 0, 0, -3}), {1, 0, 0})})
                     .contractivity,
                 3.0);
        Random random(5);
        for (int n = 0; n < 300; ++n) {
            const Maps2 maps{{leaning(random), randomVector<2>(random)}};
            const Verdict verdict = classify<2>(maps).verdict;
            if (exactExpansion<2>(maps, {0}) == Expansion::Yes)
                QCOMPARE(verdict, Verdict::None);
            else
                QVERIFY(verdict == Verdict::EventuallyContractive || verdict == Verdict::Hyperbolic);
        }
    }

    void slowMapsAlongTheAxes() {
        QVERIFY(exists(classify<2>(Maps2{affineMap(0, .5, 1, 0, 1, 0),
                                         affineMap(0, .9999999999999991, .9999999999999991, 0, 0, 1)})));
        QVERIFY(exists(
            classify<3>(Maps3{map3(matrix3({0, 0, 1048576, 0, .999999999999999, 0, 0, 0, 0}), {1, 0, 0}),
                              map3(matrix3({0, 0, 0, 0, -.9, 0, 9e-7, 0, 0}), {0, 1, 0})})));
        for (const double slow : {1 - 1e-12, 1 - 1e-14, 1 - 0x1p-50, 1 - 0x1p-51}) {
            const Existence leaning =
                classify<2>(Maps2{affineMap(slow, 7, 0, .5, 1, 0), affineMap(.5, -3, 0, -slow, 0, 1)});
            QVERIFY(exists(leaning));
            QVERIFY(leaning.contractivity >= slow && leaning.contractivity < 1);
            const Matrix<3> upper = matrix3({slow, 9, 1e5, 0, .5, 1, 0, 0, -slow});
            QVERIFY(exists(classify<3>(Maps3{map3(upper, {1, 0, 0}), map3(upper.transpose(), {0, 1, 0})})) ==
                    false);
            QVERIFY(exists(classify<3>(Maps3{map3(upper, {1, 0, 0}), map3(upper / 2, {0, 1, 0})})));
            // In space, norms come from rotations.
            QVERIFY(exists(classify<3>(Maps3{map3(slow * Matrix<3>::Identity(), {1, 0, 0}),
                                             map3(-slow * Matrix<3>::Identity(), {0, 1, 0})})));
        }
        // The products of 2 and ½, and of 1 and 1, are not below 1.
        QVERIFY(!exists(classify<2>(Maps2{affineMap(0, 2, 0, 0, 1, 0), affineMap(0, 0, .5, 0, 0, 1)})));
        QVERIFY(!exists(classify<2>(Maps2{affineMap(1, 1, 0, .5, 1, 0), affineMap(.5, 0, 0, .5, 0, 1)})));
    }

    // No double below 1 bounds the factors of these, and yet each has an attractor.
    void existenceNeedsNoFactor() {
        const Maps2 turns{affineMap(.28, -.96, .96, .28, 1, 0), affineMap(.14, -.48, .48, .14, 0, 1)};
        const double slow = .9999999999999999;
        const Maps2 leaning{affineMap(slow, 1, 0, .5, 1, 0), affineMap(.5, 1, 0, slow, 0, 1)};
        for (const Maps2& maps : {turns, leaning}) {
            const Existence existence = classify<2>(maps);
            QVERIFY(existence.exists());
            QVERIFY(existence.contractivity <= 1);
            const JointSpectralRadius radius = jointSpectralRadius<2>(maps, existence);
            QVERIFY(radius.most <= 1 && radius.least > .999999);
            QCOMPARE(SupportFunction<2>::of(maps).has_value(), existence.hasFactor());
        }
        QCOMPARE(classify<2>(turns).verdict, Verdict::Hyperbolic);
        QCOMPARE(classify<2>(turns).contractivity, 1.0);
        // One unit more in a last place, and lengths grow.
        const Maps2 longer{affineMap(.28, -.96, std::nextafter(.96, 1), .28, 1, 0), turns[1]};
        QVERIFY(!classify<2>(longer).exists());
        const Maps2 fixed{affineMap(1, 1, 0, .5, 1, 0), leaning[1]};
        QCOMPARE(classify<2>(fixed).verdict, Verdict::None);
    }

    void slowFamilies_data() {
        QTest::addColumn<int>("kind");
        QTest::newRow("similarities") << int(Slow::Similarities);
        QTest::newRow("triangular maps") << int(Slow::Triangular);
        QTest::newRow("maps across the axes") << int(Slow::AcrossTheAxes);
        QTest::newRow("maps with a common direction") << int(Slow::CommonDirection);
    }
    void slowFamilies() {
        QFETCH(const int, kind);
        Random random(11);
        int undecided = 0;
        constexpr int trials = 200;
        for (int n = 0; n < trials; ++n) {
            const Maps2 maps = slowMaps(Slow(kind), random);
            const Existence existence = classify<2>(maps);
            if (existence.exists()) QVERIFY(areShortWordsBelowOne<2>(maps));
            if (existence.verdict == Verdict::None)
                QCOMPARE(exactExpansion<2>(maps, existence.witness), Expansion::Yes);
            // Lengths that two rotations keep but for rounding may grow along words that nobody finds.
            undecided += existence.verdict == Verdict::Undecided && areShortWordsBelowOne<2>(maps) ? 1 : 0;
        }
        QVERIFY2(undecided * 100 <= trials, qPrintable(QString::number(undecided)));
    }

    void slowSolidsAreDecided() {
        Random random(12);
        int undecided = 0;
        for (int n = 0; n < 100; ++n) {
            const Maps3 maps = slowSolids(n % 2 == 0 ? Slow::Blocks : Slow::Triangular, random);
            const Existence existence = classify<3>(maps);
            if (existence.exists()) QVERIFY(areShortWordsBelowOne<3>(maps));
            undecided += existence.verdict == Verdict::Undecided && areShortWordsBelowOne<3>(maps) ? 1 : 0;
        }
        QVERIFY2(undecided <= 1, qPrintable(QString::number(undecided)));
    }

    void jointTriangularity() {
        Random random(13);
        for (int n = 0; n < 50; ++n) {
            Matrix<3> upper[2], turned[2];
            // Columns of a unimodular integer matrix and its inverse: conjugation is exact.
            const Matrix<3> basis = matrix3({1, 2, 3, 0, 1, 4, 5, 6, 0});
            const Matrix<3> inverse = matrix3({-24, 18, 5, 20, -15, -4, -5, 4, 1});
            for (int k = 0; k < 2; ++k) {
                upper[k] = Matrix<3>::Zero();
                for (int i = 0; i < 3; ++i)
                    for (int j = i; j < 3; ++j)
                        upper[k](i, j) = shortNumber(random);
                turned[k] = basis * upper[k] * inverse;
            }
            QVERIFY(areJointlyTriangular<3>(Maps3{map3(turned[0], {0, 0, 0}), map3(turned[1], {0, 0, 0})}));
            turned[1](n % 3, n / 3 % 3) += 0x1p-20;
            QVERIFY(!areJointlyTriangular<3>(Maps3{map3(turned[0], {0, 0, 0}), map3(turned[1], {0, 0, 0})}));
        }
        // Rotations about one point have complex directions in common.
        QVERIFY(areJointlyTriangular<2>(
            Maps2{affineMap(.28, -.96, .96, .28, 1, 0), affineMap(.14, -.48, .48, .14, 0, 1)}));
        QVERIFY(!areJointlyTriangular<2>(Maps2{affineMap(0, 1, 0, 0, 0, 0), affineMap(0, 0, 1, 0, 0, 0)}));
        // Pairs of these three keep a direction, all of them keep none.
        QVERIFY(!areJointlyTriangular<2>(
            Maps2{affineMap(1, 1, 0, 2, 0, 0), affineMap(1, 0, 1, 2, 0, 0), affineMap(3, 0, 0, 1, 0, 0)}));
    }

    // A norm that decides holds for all words, with their rounding.
    void normsOfCancellingWords() {
        for (const double scale : {1.0, .125, .75, 2.5}) {
            const Maps2 maps{{cancelling(scale), {1, 0}}, {cancelling(scale), {0, 1}}};
            const Existence existence = classify<2>(maps);
            QCOMPARE(exists(existence), scale < 2);
            if (!exists(existence)) continue;
            QVERIFY(existence.contractivity >= scale / 2);
            const auto norm = contractingNorm<2>(maps, existence);
            QVERIFY(norm.contractivity >= scale / 2);
        }
        // A² is q times the identity, with q less than 1 by little more than what rounding takes from it.
        Random random(14);
        for (int n = 0; n < 200; ++n) {
            const double a = 30 + uniform(random), b = 30 + uniform(random), c = (1 - 2e-12 - a * a) / b;
            const Dyadic q = Dyadic(a) * Dyadic(a) + Dyadic(b) * Dyadic(c);
            const Existence existence = classify<2>(Maps2{affineMap(a, b, c, -a, 1, 0)});
            QVERIFY(exists(existence));
            if (existence.norm != NormKind::Words || existence.wordLength != 2) continue;
            const Dyadic square = Dyadic(existence.contractivity) * Dyadic(existence.contractivity);
            QVERIFY2((square + Dyadic(0x1p-50) - q).sign() >= 0, qPrintable(QString::number(n)));
        }
    }
};

BARYCAGE_TEST(ExactExistenceTest);
#include "exact_existence_test.moc"
