// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/existence/attractor_existence.h"
#include "ifs/existence/conditioning.h"
#include "ifs/existence/expansion.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>
#include <limits>

using namespace ifs;
using namespace canonical;

namespace {

bool exists(const Existence& existence) {
    return existence.verdict == Verdict::Hyperbolic || existence.verdict == Verdict::EventuallyContractive;
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

// Whether ρ < 1/(1 + 2⁻⁵²), without rounding.
bool isBelowOne(const Maps2& maps) {
    return exactExpansion<2>(Maps2{maps[0], {(1 + 0x1p-52) * Matrix<2>::Identity(), {0, 0}}}, {0, 1}) ==
           Expansion::No;
}

} // namespace

// Systems on which numbers overflow, or cancel to less than their rounding. All of them are decided by what
// is known of them without rounding.
class ExactExistenceTest : public QObject {
    Q_OBJECT

private slots:
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

    // By the exact signs alone, however near ρ is to 1 and however much the coefficients cancel; only where
    // no double below 1 is a factor, the answer stays open.
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
            else if (isBelowOne(maps))
                QVERIFY(verdict == Verdict::EventuallyContractive || verdict == Verdict::Hyperbolic);
            else
                QVERIFY(verdict != Verdict::None);
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
    }
};

BARYCAGE_TEST(ExactExistenceTest);
#include "exact_existence_test.moc"
