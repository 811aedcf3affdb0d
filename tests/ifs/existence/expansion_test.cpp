// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/existence/dyadic.h"
#include "ifs/existence/expansion.h"
#include "ifs/existence/polytope_norm.h"
#include "support/named_test.h"

#include <QtTest>

using namespace ifs;
using namespace canonical;

class ExpansionTest : public QObject {
    Q_OBJECT

private slots:
    void sumsAndProductsDoNotRound() {
        Random random(1);
        for (int n = 0; n < 2000; ++n) {
            const auto number = [&] { return std::ldexp(uniform(random), int(random() % 400) - 200); };
            const double a = number(), b = number(), c = number();
            const Dyadic x(a), y(b), z(c);
            QVERIFY((x + y) - y == x);
            QVERIFY((x + y) * z == x * z + y * z);
            QVERIFY((x - y) * (x + y) == x * x - y * y);
            QCOMPARE((x * y).sign(), (a > 0) == (b > 0) ? 1 : -1);
            QCOMPARE((x - y).sign(), a > b ? 1 : -1);
        }
        QCOMPARE(Dyadic(0).sign(), 0);
        QCOMPARE((Dyadic(1e300) + Dyadic(5e-324) - Dyadic(1e300)).sign(), 1);
        QVERIFY(Dyadic(1 + 0x1p-52) * Dyadic(1 - 0x1p-52) + Dyadic(0x1p-104) == Dyadic(1));
    }

    void radiusOfOne() {
        const Maps2 maps{affineMap(1, 5, 0, .5, 0, 0), affineMap(1 - 0x1p-53, 5, 0, .5, 0, 0),
                         affineMap(2, 0, 0, .25, 0, 0), affineMap(.5, 0, 0, 4, 0, 0),
                         affineMap(0, -1, 1, 0, 0, 0)};
        const std::span<const AffineMap<2>> all = maps;
        QCOMPARE(exactExpansion<2>(all, {0}), Expansion::Yes);
        QCOMPARE(exactExpansion<2>(all, {1}), Expansion::No);
        QCOMPARE(exactExpansion<2>(all, {2, 3}), Expansion::Yes);
        QCOMPARE(exactExpansion<2>(all, {2, 3, 1}), Expansion::No);
        QCOMPARE(exactExpansion<2>(all, {4}), Expansion::Yes);
        QCOMPARE(expansion<2>(maps[1].linear, 0), Expansion::Unknown);
        QCOMPARE(expansion<2>(maps[2].linear, 0), Expansion::Yes);
        QCOMPARE(expansion<2>(0.9 * Matrix<2>::Identity(), 1e-3), Expansion::No);
        QCOMPARE(expansion<2>(0.99 * Matrix<2>::Identity(), 2e-2), Expansion::Unknown);
    }

    // Against eigenvalues of matrices that are near enough to normal.
    void agreesWithEigenvalues() {
        Random random(2);
        for (int n = 0; n < 2000; ++n) {
            const Matrix<2> flat = randomMatrix<2>(random, 1.3);
            const Matrix<3> solid = randomMatrix<3>(random, 1.1);
            if (std::abs(spectralRadius<2>(flat) - 1) > 1e-6)
                QCOMPARE(expansion<2>(flat, 1e-12),
                         spectralRadius<2>(flat) > 1 ? Expansion::Yes : Expansion::No);
            if (std::abs(spectralRadius<3>(solid) - 1) > 1e-6) {
                QCOMPARE(expansion<3>(solid, 1e-12),
                         spectralRadius<3>(solid) > 1 ? Expansion::Yes : Expansion::No);
                QCOMPARE(exactExpansion<3>(Maps3{map3(solid, {0, 0, 0})}, {0}), expansion<3>(solid, 1e-12));
            }
        }
    }

    // Turns by one radian and shrinks by a factor: the ball is nearly the unit disc.
    void polytopeOfARotation() {
        for (const double ratio : {0.5, 0.99}) {
            const Maps2 maps{similarity(ratio, 1, 0, 0)};
            QVERIFY(!polytopeNorm<2>(maps, ratio - 1e-6));
            const auto norm = polytopeNorm<2>(maps, (1 + ratio) / 2);
            QVERIFY(norm && norm->contractivity >= ratio && norm->contractivity < 1);
            QVERIFY(norm->equivalence >= 1 && norm->equivalence < 3);
            QVERIFY(!polytopeNorm<2>(maps, (1 + ratio) / 2, 0.5)); // coefficients may be off by too much
        }
        const auto inSpace = polytopeNorm<3>(fern3(), 0.93);
        QVERIFY(inSpace && inSpace->contractivity < 0.94);
    }
};

BARYCAGE_TEST(ExpansionTest);
#include "expansion_test.moc"
