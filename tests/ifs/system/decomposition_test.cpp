// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/system/decomposition.h"
#include "support/named_test.h"
#include "support/near.h"

#include <Eigen/LU>

#include <QtTest>

using namespace ifs;
using namespace canonical;

namespace {

using support::near;

// General, singular, reflected, tiny and huge matrices.
template <int Dim> Matrix<Dim> anyMatrix(Random& random) {
    Matrix<Dim> m = randomMatrix<Dim>(random, std::pow(10, uniform(random, -3, 3)));
    if (random() % 4 == 0) m.col(int(random() % Dim)).setZero();
    if (random() % 4 == 0) m.col(Dim - 1) = 2 * m.col(0);
    if (random() % 8 == 0) m.row(int(random() % Dim)).setZero();
    return m;
}

template <int Dim> void polarRecomposes() {
    Random random(1);
    for (int n = 0; n < 5000; ++n) {
        const Matrix<Dim> m = anyMatrix<Dim>(random);
        const double size = spectralNorm<Dim>(m);
        const Polar<Dim> parts = polar<Dim>(m);
        QVERIFY((parts.rotation * parts.stretch - m).norm() <= 2e-14 * size);
        QVERIFY((parts.rotation.transpose() * parts.rotation - Matrix<Dim>::Identity()).norm() <= 1e-14);
        QVERIFY(near(parts.rotation.determinant(), 1, 1e-14));
        QVERIFY((parts.stretch - parts.stretch.transpose()).norm() <= 1e-14 * size);
    }
}

} // namespace

class DecompositionTest : public QObject {
    Q_OBJECT

private slots:
    void partsOfMaple() {
        const auto w3 = rotationScaleShear(maple()[2].linear);
        QVERIFY(near(w3.rotation, -0.432407775571, 1e-12) && near(w3.scaleX, 0.715891053164, 1e-12));
        QVERIFY(near(w3.scaleY, 0.557347376024, 1e-12) && near(w3.shear, 0.086829268293, 1e-12));
        const auto w4 = rotationScaleShear(maple()[3].linear);
        QVERIFY(near(w4.rotation, 0.244978663127, 1e-12) && near(w4.scaleX, 0.659696900099, 1e-12));
        QVERIFY(near(w4.scaleY, 0.616040487592, 1e-12) && near(w4.shear, -4. / 17, 1e-12));
        const auto w1 = rotationScaleShear(maple()[0].linear);
        QVERIFY(near(w1.rotation, -1.742987141318, 1e-12) && near(w1.scaleX, 0.233452350599, 1e-12));
        QVERIFY(near(w1.scaleY, 0.111371763588, 1e-12) && near(w1.shear, 2.743119266055, 1e-12));
        const auto angle = [](const Matrix<2>& rotation) {
            return std::atan2(rotation(1, 0), rotation(0, 0));
        };
        QVERIFY(near(angle(polar<2>(maple()[2].linear).rotation), -0.481189669058, 1e-12));
        QVERIFY(near(angle(polar<2>(maple()[3].linear).rotation), 0.366056515847, 1e-12));
    }

    void partsRecompose2() {
        Random random(2);
        for (int n = 0; n < 10'000; ++n) {
            const Matrix<2> m = anyMatrix<2>(random);
            const auto parts = rotationScaleShear(m);
            QVERIFY(parts.scaleX >= 0 && std::isfinite(parts.shear));
            QVERIFY((linearPart(parts) - m).norm() <= 2e-14 * spectralNorm<2>(m));
            QVERIFY(near(parts.scaleX * parts.scaleY, determinant<2>(m), 1e-14 * m.squaredNorm()));
        }
        Matrix<2> noFirstColumn;
        noFirstColumn << 0, 3, 0, 4;
        const auto parts = rotationScaleShear(noFirstColumn);
        QCOMPARE(parts.scaleX, 0.0);
        QCOMPARE(parts.scaleY, 5.0);
        QCOMPARE(rotationScaleShear(Matrix<2>(Matrix<2>::Zero())).rotation, 0.0);
    }

    void partsRecompose3() {
        Random random(3);
        for (int n = 0; n < 5000; ++n) {
            const Matrix<3> m = anyMatrix<3>(random);
            const auto parts = rotationScaleShear(m);
            QVERIFY((parts.rotation * parts.scale.asDiagonal() * parts.shear - m).norm() <= 2e-14 * m.norm());
            QVERIFY((parts.rotation.transpose() * parts.rotation - Matrix<3>::Identity()).norm() <= 1e-14);
            QVERIFY(near(parts.rotation.determinant(), 1, 1e-14));
            QVERIFY(parts.scale[0] >= 0 && parts.scale[1] >= 0 && parts.shear.allFinite());
            QVERIFY(parts.shear.isUpperTriangular(0));
            QVERIFY((linearPart(parts) - m).norm() <= 2e-14 * m.norm());
            const AxisAngle turn = axisAngle(parts.rotation);
            QVERIFY(near(turn.axis.norm(), 1, 1e-14));
            QVERIFY(turn.angle >= 0 && turn.angle <= 3.1415926535897936);
            QVERIFY((rotationAbout(turn) - parts.rotation).norm() <= 1e-14);
        }
    }

    void axesAndAngles() {
        Matrix<3> quarter; // x to y, seen from the tip of z
        quarter << 0, -1, 0, 1, 0, 0, 0, 0, 1;
        const AxisAngle turn = axisAngle(quarter);
        QVERIFY((turn.axis - Vector<3>(0, 0, 1)).norm() < 1e-15);
        QVERIFY(near(turn.angle, 1.5707963267948966, 1e-15));
        QVERIFY((rotationAbout({{0, 0, 1e-200}, turn.angle}) - quarter).norm() < 1e-15);
        QVERIFY((rotationAbout({{0, 0, -7}, -turn.angle}) - quarter).norm() < 1e-15);
        QVERIFY(rotationAbout({{0, 0, 0}, 1}) == Matrix<3>(Matrix<3>::Identity()));
        QVERIFY(rotationAbout(axisAngle(Matrix<3>::Identity())) == Matrix<3>(Matrix<3>::Identity()));
    }

    // Turns about axes in a plane of coordinates: none of what is 0 comes out as 1e-17.
    void whatIsNotThereIsZero() {
        Random random(5);
        const auto isKnown = [](double x) { return x == 0 || std::abs(x) > 1e-9; };
        for (int n = 0; n < 2000; ++n) {
            Vector<3> axis = Vector<3>::Zero();
            axis[n % 3] = uniform(random);
            axis[(n + 1) % 3] = uniform(random);
            if (axis.norm() < 0.1) continue;
            const Matrix<3> rotation = rotationAbout({axis, uniform(random, 0.1, 3)});
            const Vector<3> scale(uniform(random, 0.1, 1), uniform(random, 0.1, 1), uniform(random, 0.1, 1));
            const auto parts = rotationScaleShear(Matrix<3>(rotation * scale.asDiagonal()));
            QVERIFY(parts.shear(0, 1) == 0 && parts.shear(0, 2) == 0 && parts.shear(1, 2) == 0);
            const AxisAngle turn = axisAngle(parts.rotation);
            QVERIFY(isKnown(turn.axis.x()) && isKnown(turn.axis.y()) && isKnown(turn.axis.z()));
        }
        Matrix<3> flat;
        flat << 0.3, 0.1, 0.7, 0.2, 0.5, 0.9, 0.5, 0.6, 1.6; // the third row is the sum of the others
        QCOMPARE(rotationScaleShear(flat).scale.z(), 0.0);
    }

    void polarRecomposes2() { polarRecomposes<2>(); }
    void polarRecomposes3() { polarRecomposes<3>(); }

    void kinds() {
        QCOMPARE(kind<2>(similarity(.3, 1, 0, 0).linear), MapKind::Similarity);
        QCOMPARE(kind<2>(affineMap(.3, .4, .4, -.3, 0, 0).linear), MapKind::ReflectedSimilarity);
        QCOMPARE(kind<2>(maple()[2].linear), MapKind::Affine);
        QCOMPARE(kind<2>(fern()[0].linear), MapKind::Singular);
        QCOMPARE(kind<2>(affineMap(.1, .3, .2, .6, 0, 0).linear), MapKind::Singular);
        QCOMPARE(kind<2>(affineMap(0, 0, 0, 0, 1, 2).linear), MapKind::Constant);
        QCOMPARE(kind<2>(affineMap(1e-5, 0, 0, .5, 0, 0).linear), MapKind::Affine);
        QCOMPARE(kind<3>(cube()[3].linear), MapKind::Similarity);
        QCOMPARE(kind<3>(Matrix<3>(-cube()[3].linear)), MapKind::ReflectedSimilarity);
        QCOMPARE(kind<3>(fern3()[0].linear), MapKind::Singular);
        QCOMPARE(kind<3>(fern3()[2].linear), MapKind::Affine);
    }
};

BARYCAGE_TEST(DecompositionTest);
#include "decomposition_test.moc"
