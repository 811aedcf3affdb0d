// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/control_cage.h"

#include <QtTest>

using namespace ifs;
using namespace canonical;

namespace {

const Simplex<2> Triangle{Vector<2>(0, 0), Vector<2>(4, 0), Vector<2>(0, 3)};

template <int Dim> Simplex<Dim> randomSimplex(Random& random, double size = 5) {
    for (;;) {
        Simplex<Dim> simplex;
        for (auto& v : simplex)
            v = randomVector<Dim>(random, size);
        Matrix<Dim> edges;
        for (int k = 0; k < Dim; ++k)
            edges.col(k) = simplex[k + 1] - simplex[0];
        if (singularValues<Dim>(edges)[Dim - 1] > 0.05 * size) return simplex;
    }
}

template <int Dim> void coordinateProperties() {
    Random random(1);
    for (int n = 0; n < 2000; ++n) {
        const Simplex<Dim> simplex = randomSimplex<Dim>(random);
        const Vector<Dim> x = randomVector<Dim>(random, 5);
        const Barycentric<Dim> lambda = barycentric<Dim>(simplex, x);
        QVERIFY(std::abs(lambda.sum() - 1) <= 1e-15 * (1 + lambda.cwiseAbs().maxCoeff()));
        QVERIFY((point<Dim>(simplex, lambda) - x).norm() <= 1e-12);

        const AffineMap<Dim> t{randomWellConditioned<Dim>(random), randomVector<Dim>(random, 5)};
        Simplex<Dim> image;
        for (int k = 0; k <= Dim; ++k)
            image[k] = t(simplex[k]);
        QVERIFY((barycentric<Dim>(image, t(x)) - lambda).norm() <= 1e-12 * (1 + lambda.norm()) * 10);
        const AffineMap<Dim> found = simplexMap<Dim>(simplex, image);
        QVERIFY((found.linear - t.linear).norm() <= 1e-12);
        QVERIFY((found(x) - t(x)).norm() <= 1e-11);

        Simplex<Dim> relabelled = simplex;
        std::rotate(relabelled.begin(), relabelled.begin() + 1, relabelled.end());
        const Barycentric<Dim> mu = barycentric<Dim>(relabelled, x);
        for (int k = 0; k <= Dim; ++k)
            QVERIFY(std::abs(mu[k] - lambda[(k + 1) % (Dim + 1)]) <= 1e-12 * (1 + lambda.norm()));

        for (int k = 0; k <= Dim; ++k) { // a vertex has unit coordinates, and they return exactly that vertex
            const Barycentric<Dim> unit = barycentric<Dim>(simplex, simplex[k]);
            QVERIFY((unit == Barycentric<Dim>::Unit(k)));
            QVERIFY(point<Dim>(simplex, unit) == simplex[k]);
        }
    }
}

template <int Dim> void flattenAndReopen() {
    Random random(2);
    for (int n = 0; n < 1000; ++n) {
        ControlCage<Dim> cage = cageAtRest<Dim>(randomSimplex<Dim>(random));
        cage.current[0] += randomVector<Dim>(random);
        const ControlCage<Dim> start = cage;
        const AffineMap<Dim> map = displayMap(cage);
        cage.current[0] = (cage.current[1] + cage.current[2]) / 2; // on one line (in one plane)
        QVERIFY(isValid(cage));
        QVERIFY(!isInvertible(cage));
        QVERIFY(isFinite(displayMap(cage)));
        QVERIFY(singularValues<Dim>(displayMap(cage).linear)[Dim - 1] <= 1e-12);
        QVERIFY(!bake(IteratedFunctionSystem<Dim>{}, cage));
        cage.current[0] = start.current[0];
        QCOMPARE(displayMap(cage), map);
        for (int k = 0; k <= Dim; ++k)
            QVERIFY((map(cage.rest[std::size_t(k)]) - cage.current[std::size_t(k)]).norm() <= 1e-12);
    }
}

template <int Dim> void bakedCageShowsTheSame() {
    Random random(3);
    for (int n = 0; n < 1000; ++n) {
        const auto maps = randomContractions<Dim>(random, 3);
        const Simplex<Dim> rest = randomSimplex<Dim>(random), current = randomSimplex<Dim>(random);
        ControlCage<Dim> cage = cageAtRest<Dim>(rest);
        cage.current.assign(current.begin(), current.end());
        const auto baked = bake(canonical::system<Dim>(maps), cage);
        QVERIFY(baked.has_value());
        QCOMPARE(baked->cage.rest, cage.current);
        QCOMPARE(baked->cage.current, cage.current);
        QCOMPARE(displayMap(baked->cage), AffineMap<Dim>{});
        const AffineMap<Dim> display = displayMap(cage);
        for (std::size_t i = 0; i < maps.size(); ++i) {
            const Vector<Dim> x = randomVector<Dim>(random, 5);
            QVERIFY((baked->system.maps[i].map(display(x)) - display(maps[i](x))).norm() <= 1e-9);
        }
    }
}

} // namespace

class ControlCageTest : public QObject {
    Q_OBJECT

private slots:
    void coordinatesInTheTriangle() {
        QVERIFY((barycentric<2>(Triangle, {1, 1}) - Barycentric<2>(5. / 12, 1. / 4, 1. / 3)).norm() < 1e-16);
    }
    void coordinatesInTheTetrahedron() {
        const Simplex<3> simplex{Vector<3>(0, 0, 0), Vector<3>(2, 0, 0), Vector<3>(0, 3, 0),
                                 Vector<3>(0, 0, 4)};
        const Barycentric<3> expected(1. / 6, 1. / 4, 1. / 3, 1. / 4);
        QVERIFY((barycentric<3>(simplex, {.5, 1, 1}) - expected).norm() < 2e-16);
    }
    void coordinateProperties2() { coordinateProperties<2>(); }
    void coordinateProperties3() { coordinateProperties<3>(); }

    void mirroringKeepsTheCoordinates() {
        Random random(4);
        for (int n = 0; n < 1000; ++n) {
            Simplex<2> simplex = randomSimplex<2>(random);
            Vector<2> x = randomVector<2>(random, 5);
            const Barycentric<2> lambda = barycentric<2>(simplex, x);
            for (auto& v : simplex)
                v.y() = -v.y();
            x.y() = -x.y();
            QVERIFY((barycentric<2>(simplex, x) == lambda)); // signs only: the same bits
        }
    }

    void flatSimplicesAreNoBasis() {
        QVERIFY(isAffineBasis<2>(Triangle));
        QVERIFY(!isAffineBasis<2>({Vector<2>(0, 0), Vector<2>(1, 1), Vector<2>(2, 2)}));
        QVERIFY(!isAffineBasis<2>({Vector<2>(1, 1), Vector<2>(1, 1), Vector<2>(1, 1)}));
        QVERIFY(!isAffineBasis<2>({Vector<2>(0, 0), Vector<2>(1, 0), Vector<2>(0.5, 0.9e-9)}));
        QVERIFY(isAffineBasis<2>({Vector<2>(0, 0), Vector<2>(1, 0), Vector<2>(0.5, 1.1e-9)}));
        QVERIFY(!isAffineBasis<2>({Vector<2>(0, 0), Vector<2>(NaN, 0), Vector<2>(0, 1)}));
        QVERIFY(!isAffineBasis<2>({Vector<2>(0, 0), Vector<2>(Infinity, 0), Vector<2>(0, 1)}));
        for (const double size : {1e-150, 1e150}) {
            const Simplex<3> huge{Vector<3>::Zero(), size * Vector<3>::Unit(0), size * Vector<3>::Unit(1),
                                  size * Vector<3>::Unit(2)};
            QVERIFY(isAffineBasis<3>(huge));
        }
    }

    void flattenAndReopen2() { flattenAndReopen<2>(); }
    void flattenAndReopen3() { flattenAndReopen<3>(); }

    void restShowsTheIdentity() {
        Random random(6);
        for (int n = 0; n < 1000; ++n)
            QCOMPARE(displayMap(cageAtRest<2>(randomSimplex<2>(random))), AffineMap<2>{});
    }

    void bakedCageShowsTheSame2() { bakedCageShowsTheSame<2>(); }
    void bakedCageShowsTheSame3() { bakedCageShowsTheSame<3>(); }

    void redefinedCageShowsTheSame() {
        Random random(8);
        for (int n = 0; n < 1000; ++n) {
            ControlCage<2> cage = cageAtRest<2>(randomSimplex<2>(random));
            const Simplex<2> current = randomSimplex<2>(random), clicks = randomSimplex<2>(random);
            cage.current.assign(current.begin(), current.end());
            const auto redefined = redefine<2>(cage, clicks);
            QVERIFY(redefined.has_value());
            QVERIFY(std::ranges::equal(redefined->current, clicks));
            const Vector<2> x = randomVector<2>(random, 5);
            QVERIFY((displayMap(*redefined)(x) - displayMap(cage)(x)).norm() <= 1e-9);
        }
        ControlCage<2> flat = cageAtRest<2>(Triangle);
        flat.current[2] = flat.current[1];
        QVERIFY(!redefine<2>(flat, Triangle));
        QVERIFY(!redefine<2>(cageAtRest<2>(Triangle), {Vector<2>(0, 0), Vector<2>(1, 0), Vector<2>(2, 0)}));
    }

    void validity() {
        ControlCage<2> cage = cageAtRest<2>(Triangle);
        QVERIFY(isValid(cage));
        cage.current[1] = cage.current[0];
        QVERIFY(isValid(cage));
        cage.current[1].x() = NaN;
        QVERIFY(!isValid(cage));
        cage = cageAtRest<2>(Triangle);
        cage.rest[2] = {2, 0};
        QVERIFY(!isValid(cage));
        cage.rest = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        QVERIFY(!isValid(cage));
        cage.current = cage.rest;
        QVERIFY(isValid(cage));
        cage.rest[1] = cage.rest[0];
        QVERIFY(!isValid(cage));
        cage.rest = {{0, 0}, {1, 0}, {2, 0}, {3, 0}};
        QVERIFY(!isValid(cage));
        QVERIFY(!isValid(ControlCage<2>{}));
    }
};

QTEST_APPLESS_MAIN(ControlCageTest)
#include "control_cage_test.moc"
