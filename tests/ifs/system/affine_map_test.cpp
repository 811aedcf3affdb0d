// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/system/affine_map.h"
#include "support/named_test.h"
#include "support/near.h"

#include <Eigen/Eigenvalues>

#include <QtTest>

using namespace ifs;
using namespace canonical;

namespace {

using support::near;
Vector<2> fix(const AffineMap<2>& map) {
    return *fixedPoint(map);
}

// Against Eigen's eigenvalues of AᵀA and of A, random matrices of many sizes.
template <int Dim> void compareWithEigen() {
    Random random(Dim);
    for (int n = 0; n < 10'000; ++n) {
        const double size = std::pow(10.0, uniform(random, -60, 60));
        const Matrix<Dim> m = randomMatrix<Dim>(random, size);
        const Vector<Dim> sigma = singularValues<Dim>(m);
        const Eigen::MatrixXd unit = m / size;
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> gram(unit.transpose() * unit);
        QVERIFY(near(sigma[0] / size, std::sqrt(gram.eigenvalues()[Dim - 1]), 4e-15));
        QVERIFY(std::is_sorted(sigma.data(), sigma.data() + Dim, std::greater{}));
        double product = 1;
        for (int k = 0; k < Dim; ++k)
            product *= sigma[k] / size;
        const double det = std::abs((m / size).determinant());
        QVERIFY(near(product, det, 1e-14));
        const double rho = Eigen::EigenSolver<Eigen::MatrixXd>(m / size).eigenvalues().cwiseAbs().maxCoeff();
        QVERIFY(
            near(spectralRadius<Dim>(m) / size, rho, 1e-7)); // 1e-7: a double eigenvalue has half the digits
        QVERIFY(spectralRadius<Dim>(m) <= spectralNorm<Dim>(m) * (1 + 1e-12));
    }
}

template <int Dim> void neverNaN() {
    for (const double bad : {quietNaN, infinity, -infinity, 1e308, 1e-320, 0.0}) {
        AffineMap<Dim> map;
        map.linear(0, Dim - 1) = bad;
        map.translation[0] = bad;
        QVERIFY(!std::isnan(spectralNorm<Dim>(map.linear)));
        QVERIFY(!std::isnan(spectralRadius<Dim>(map.linear)));
        QVERIFY(!singularValues<Dim>(map.linear).hasNaN());
        for (const auto& result : {inverse(map), conjugate(map, map)})
            QVERIFY(!result || isFinite(*result));
        const auto fixed = fixedPoint(map);
        QVERIFY(!fixed || fixed->allFinite());
        if (!std::isfinite(bad)) QCOMPARE(spectralNorm<Dim>(map.linear), infinity);
    }
    QCOMPARE(spectralNorm<Dim>(Matrix<Dim>::Zero()), 0.0);
    QCOMPARE(spectralRadius<Dim>(Matrix<Dim>::Zero()), 0.0);
    QVERIFY(spectralNorm<Dim>(Matrix<Dim>::Constant(1e308)) > 1e308);
}

template <int Dim> void inverseAndConjugate() {
    Random random(7);
    for (int n = 0; n < 1000; ++n) {
        const AffineMap<Dim> t{randomWellConditioned<Dim>(random), randomVector<Dim>(random, 5)};
        const AffineMap<Dim> w{randomMatrix<Dim>(random), randomVector<Dim>(random, 5)};
        const Vector<Dim> x = randomVector<Dim>(random, 5);
        const double scale = t(x).norm() + t.translation.norm() + 10;
        QVERIFY(near<Dim>((*inverse(t))(t(x)), x, 1e-13 * scale * 10));
        QVERIFY(near<Dim>((*conjugate(t, w))(t(x)), t(w(x)), 1e-12 * scale * 10));
        QVERIFY(near<Dim>((t * w)(x), t(w(x)), 1e-13 * scale));
    }
    QVERIFY(!inverse(AffineMap<Dim>{Matrix<Dim>::Ones(), Vector<Dim>::Zero()}));
    QVERIFY(!conjugate(AffineMap<Dim>{Matrix<Dim>::Zero(), Vector<Dim>::Zero()}, AffineMap<Dim>{}));
}

} // namespace

class AffineMapTest : public QObject {
    Q_OBJECT

private slots:
    void singularValuesOfMaple() {
        const double expected[4][2] = {{0.689622051179, 0.037701810659},
                                       {0.61, 0.31},
                                       {0.722524371029, 0.552230507369},
                                       {0.723195530540, 0.561950375574}};
        const double dets[] = {0.026, 0.1891, 0.399, 0.4064};
        for (std::size_t i = 0; i < 4; ++i) {
            const Matrix<2> linear = maple()[i].linear;
            QVERIFY(near(singularValues<2>(linear)[0], expected[i][0], 1e-12));
            QVERIFY(near(singularValues<2>(linear)[1], expected[i][1], 1e-12));
            QVERIFY(near(determinant<2>(linear), dets[i], 1e-15));
        }
        QVERIFY(near(spectralNorm<2>(flower()[0].linear), 0.557584074378, 1e-12));
        QVERIFY(near(spectralNorm<2>(flower()[1].linear), 0.560802995712, 1e-12));
        const double fernNorms[] = {0.16, 0.850940656, 0.340711814, 0.379151772};
        for (std::size_t i = 0; i < 4; ++i)
            QVERIFY(near(spectralNorm<2>(fern()[i].linear), fernNorms[i], 2e-9));
    }

    void singularValues2() { compareWithEigen<2>(); }
    void singularValues3() { compareWithEigen<3>(); }

    void spectralRadiusOfKnownMatrices() {
        Matrix<2> shear;
        shear << .5, 2, 0, .5;
        QCOMPARE(spectralRadius<2>(shear), 0.5);
        QVERIFY(near(spectralNorm<2>(shear), (std::sqrt(5) + 2) / 2, 1e-15));
        QVERIFY(near(spectralRadius<2>(koch()[1].linear), 1.0 / 3, 1e-15));
        Matrix<3> m;
        m << 0, -2, 0, 2, 0, 0, 0, 0, 1.5;
        QVERIFY(near(spectralRadius<3>(m), 2, 1e-14));
    }

    void firstSymbolOfAnAddressActsLast() {
        const Vector<2> image = maple()[3](maple()[2](maple()[1](maple()[0](Vector<2>(0, 0)))));
        QVERIFY(near<2>(image, {-0.04371984, 2.06404832}, 1e-15));
        QVERIFY(near<2>(word(maple(), {4, 3, 2, 1})({0, 0}), image, 1e-15));
        QVERIFY(
            near<2>(fix(word(maple(), {1, 2, 3, 4})), {-0.096822217864951205, -2.130418821464332372}, 1e-15));
        QVERIFY(
            near<2>(fix(word(maple(), {4, 3, 2, 1})), {-0.059093142881194517, 1.941945677813030930}, 1e-15));
        QVERIFY(near<2>(fix(word(maple(), {3, 4})), {0.953444691594398769, 1.148102263768442392}, 1e-15));
        QVERIFY(near<2>(fix(word(maple(), {4, 3})), {-0.294226076510117506, 1.395488418365431543}, 1e-15));
        QVERIFY(near<2>(fix(word(flower(), {1, 2})), {1.112817512366475760, 3.863734805287719140}, 2e-15));
        QVERIFY(near<2>(fix(word(flower(), {2, 1})), {-0.926330687597530186, 3.927309785124383157}, 2e-15));
    }

    void fixedPointNeedsAUniqueOne() {
        QVERIFY(!fixedPoint(AffineMap<2>{}));
        QVERIFY(!fixedPoint(affineMap(1, 0, 0, 0.5, 3, 4)));
        QCOMPARE(*fixedPoint(affineMap(0, 0, 0, 0, 3, 4)), Vector<2>(3, 4));
        QVERIFY(near<2>(fix(fern()[1]), {2.655783227089849, 9.958}, 1e-2));
    }

    void inverseAndConjugate2() { inverseAndConjugate<2>(); }
    void inverseAndConjugate3() { inverseAndConjugate<3>(); }

    void mirroredCodeIsTheConjugate() {
        const AffineMap<2> mirror = affineMap(1, 0, 0, -1, 0, 0);
        const AffineMap<2> w = affineMap(1, 2, 3, 4, 5, 6);
        QCOMPARE(*conjugate(mirror, w), affineMap(1, -2, -3, 4, 5, -6));
    }

    void badNumbersNeverYieldNaN() {
        neverNaN<2>();
        neverNaN<3>();
    }
};

BARYCAGE_TEST(AffineMapTest);
#include "affine_map_test.moc"
