// SPDX-License-Identifier: MIT
#include "ifs/cage/control_cage.h"
#include "ifs/canonical_systems.h"
#include "ifs/extent/extent.h"
#include "ifs/system/aifs.h"
#include "support/named_test.h"

#include <QtTest>

#include <Eigen/Eigenvalues>

using namespace ifs;
using namespace canonical;

namespace {

const Simplex<2> unitSimplex{Vector<2>(0, 0), Vector<2>(1, 0), Vector<2>(0, 1)};

RowStochastic<2> matrix(std::initializer_list<double> rows) {
    RowStochastic<2> result;
    std::ranges::copy(rows, result.transpose().reshaped().begin());
    return result;
}

template <int Dim> Simplex<Dim> randomSimplex(Random& random) {
    const Matrix<Dim> edges = randomWellConditioned<Dim>(random, 5);
    Simplex<Dim> simplex;
    simplex[0] = randomVector<Dim>(random, 2);
    for (int k = 0; k < Dim; ++k)
        simplex[std::size_t(k) + 1] = simplex[0] + edges.col(k);
    return simplex;
}

template <int Dim> void ofAifs() {
    Random random(Dim);
    for (int n = 0; n < 200; ++n) {
        const auto simplex = randomSimplex<Dim>(random), other = randomSimplex<Dim>(random);
        const auto maps = randomContractions<Dim>(random, 2);
        const auto matrices = rowStochastic<Dim>(simplex, maps);
        const auto& s = matrices[0];
        QVERIFY((s.rowwise().sum() - Barycentric<Dim>::Ones()).norm() < 1e-13);
        const auto back = affineMap<Dim>(simplex, s);
        QVERIFY((back.linear - maps[0].linear).norm() < 1e-12);
        QVERIFY((back.translation - maps[0].translation).norm() < 1e-12);
        QVERIFY((rowStochastic<Dim>(simplex, maps[0] * maps[1]) - matrices[1] * s).norm() < 1e-11);
        // The eigenvalues are 1 and those of A: compared by trace and determinant.
        QVERIFY(std::abs(s.trace() - 1 - maps[0].linear.trace()) < 1e-12);
        QVERIFY(std::abs(s.determinant() - determinant<Dim>(maps[0].linear)) < 1e-12);
        // Over another simplex the matrix is the conjugate map.
        const auto carried = *conjugate(simplexMap<Dim>(simplex, other), maps[0]);
        const auto same = affineMap<Dim>(other, s);
        QVERIFY((carried.linear - same.linear).norm() < 1e-11);
        QVERIFY((carried.translation - same.translation).norm() < 1e-11);
    }
}

} // namespace

class AifsTest : public QObject {
    Q_OBJECT

private slots:
    void sierpinski() {
        const auto s = rowStochastic<2>(unitSimplex, sierpinskiRight());
        QCOMPARE(s[0], matrix({1, 0, 0, .5, .5, 0, .5, 0, .5}));
        QCOMPARE(s[1], matrix({.5, .5, 0, 0, 1, 0, 0, .5, .5}));
        QCOMPARE(s[2], matrix({.5, 0, .5, 0, .5, .5, 0, 0, 1}));
        for (const auto& each : s)
            QVERIFY(isNonNegative<2>(each));
    }

    void flowerOverTwoTriangles() {
        const auto unit = rowStochastic<2>(unitSimplex, flower());
        QVERIFY((unit[0] - matrix({-1.11, .37, 1.74, -1.28, .84, 1.44, -1.88, .67, 2.21})).norm() < 1e-14);
        QVERIFY((unit[1] - matrix({-.41, -.34, 1.75, -1.18, .14, 2.04, -.60, -.63, 2.23})).norm() < 1e-14);
        const auto minimal = minimalCanonicalSimplex(*SupportFunction<2>::of(flower())).vertices;
        const auto s = rowStochastic<2>(minimal, flower());
        QVERIFY((s[0] - matrix({.355025595038, .405799238189, .239175166773, .185025595038, .875799238189,
                                -.060824833227, -.414974404962, .705799238189, .709175166773}))
                    .cwiseAbs()
                    .maxCoeff() < 1e-12);
        QVERIFY((s[1] - matrix({.960568270954, .039238695274, .000193033772, .190568270954, .519238695274,
                                .290193033772, .770568270954, -.250761304726, .480193033772}))
                    .cwiseAbs()
                    .maxCoeff() < 1e-12);
        QVERIFY(!isNonNegative<2>(s[0])); // the triangle contains the attractor and is not invariant
    }

    // A quadratic Bézier curve: every point of the orbit lies on the conic of its control triangle.
    void bezier() {
        const RowStochastic<2> s[] = {matrix({1, 0, 0, .5, .5, 0, .25, .5, .25}),
                                      matrix({.25, .5, .25, 0, .5, .5, 0, 0, 1})};
        Random random(1);
        Eigen::RowVector3d r(1, 0, 0);
        for (int n = 0; n < 10'000; ++n) {
            r = r * s[random() % 2];
            QVERIFY(std::abs(r[1] * r[1] - 4 * r[0] * r[2]) <= 1e-14);
        }
    }

    // The display of a moved cage, the baked code and the same matrices over the moved simplex: one picture.
    void threeRoutesToOnePicture() {
        const Simplex<2> moved{Vector<2>(1, -1), Vector<2>(3, 0), Vector<2>(.5, 2)};
        ControlCage<2> cage = cageAtRest<2>(unitSimplex);
        cage.current.assign(moved.begin(), moved.end());
        const auto baked = bake(canonical::system<2>(maple()), cage);
        QVERIFY(baked.has_value());
        const auto s = rowStochastic<2>(unitSimplex, maple());
        Random random(2);
        Vector<2> x = *fixedPoint(maple()[0]), y = displayMap(cage)(x);
        Barycentric<2> r = barycentric<2>(unitSimplex, x);
        for (int n = 0; n < 1000; ++n) {
            const std::size_t i = random() % 4;
            x = maple()[i](x);
            y = baked->system.maps[i].map(y);
            r = s[i].transpose() * r;
            QVERIFY((displayMap(cage)(x) - y).norm() < 1e-11);
            QVERIFY((point<2>(moved, r) - y).norm() < 1e-11);
        }
    }

    void planeProperties() { ofAifs<2>(); }
    void spaceProperties() { ofAifs<3>(); }
};

BARYCAGE_TEST(AifsTest);
#include "aifs_test.moc"
