// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/copies/copy.h"
#include "support/named_test.h"

#include <QtTest>

using namespace ifs;
using namespace canonical;

class CopyTest : public QObject {
    Q_OBJECT

private slots:
    void thickeningKeepsTheCentre() {
        std::mt19937 random(17);
        std::uniform_real_distribution<double> number(-1, 1);
        for (int trial = 0; trial < 1000; ++trial) {
            const Vector<2> u(number(random), number(random));
            const Vector<2> v(number(random), number(random));
            AffineMap<2> map;
            map.linear = trial % 10 == 0 ? Matrix<2>(Matrix<2>::Zero()) : Matrix<2>(u * v.transpose());
            map.translation = {number(random), number(random)};
            const Vector<2> centre(number(random), number(random));
            const AffineMap<2> thick = thickened(map, centre, 1e-3);
            const auto sigma = singularValues<2>(thick.linear);
            QVERIFY((thick(centre) - map(centre)).norm() < 1e-14);
            QVERIFY(std::abs(sigma[1] - 1e-3) < 1e-12);
            QVERIFY(std::abs(sigma[0] - std::max(1e-3, spectralNorm<2>(map.linear))) < 1e-12);
            QVERIFY(thickened(thick, centre, 0.9e-3) == thick);
        }
    }

    // Which way round the copy is, and where it is longest, stays.
    void thickeningKeepsTheDirections() {
        Random random(3);
        for (int trial = 0; trial < 1000; ++trial) {
            const AffineMap<2> map{randomWellConditioned<2>(random), randomVector<2>(random)};
            const double least = 2 * singularValues<2>(map.linear)[1];
            const AffineMap<2> thick = thickened(map, {0.3, -0.2}, least);
            QVERIFY(determinant<2>(thick.linear) * determinant<2>(map.linear) > 0);
            // A = UΣVᵀ and A' = UΣ'Vᵀ commute so: AᵀA' and A'Aᵀ are symmetric.
            const Matrix<2> inner = map.linear.transpose() * thick.linear;
            const Matrix<2> outer = thick.linear * map.linear.transpose();
            QVERIFY(std::abs(inner(0, 1) - inner(1, 0)) < 1e-12 * inner.norm());
            QVERIFY(std::abs(outer(0, 1) - outer(1, 0)) < 1e-12 * outer.norm());
            QVERIFY(thickened(map, {0.3, -0.2}, least / 2.01) == map);
        }
    }
};

BARYCAGE_TEST(CopyTest);
#include "copy_test.moc"
