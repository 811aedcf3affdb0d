// SPDX-License-Identifier: MIT
#include "ifs/cage/control_cage.h"
#include "ifs/canonical_systems.h"
#include "support/named_test.h"

#include <QtTest>

using namespace ifs;
using namespace canonical;

namespace {

const Simplex<2> triangle{Vector<2>(0, 0), Vector<2>(4, 0), Vector<2>(0, 3)};

const std::vector<Vector<2>> squareVertices{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

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
        QVERIFY((barycentric<2>(triangle, {1, 1}) - Barycentric<2>(5. / 12, 1. / 4, 1. / 3)).norm() < 1e-16);
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
        QVERIFY(isAffineBasis<2>(triangle));
        QVERIFY(!isAffineBasis<2>({Vector<2>(0, 0), Vector<2>(1, 1), Vector<2>(2, 2)}));
        QVERIFY(!isAffineBasis<2>({Vector<2>(1, 1), Vector<2>(1, 1), Vector<2>(1, 1)}));
        QVERIFY(!isAffineBasis<2>({Vector<2>(0, 0), Vector<2>(1, 0), Vector<2>(0.5, 0.9e-9)}));
        QVERIFY(isAffineBasis<2>({Vector<2>(0, 0), Vector<2>(1, 0), Vector<2>(0.5, 1.1e-9)}));
        QVERIFY(!isAffineBasis<2>({Vector<2>(0, 0), Vector<2>(quietNaN, 0), Vector<2>(0, 1)}));
        QVERIFY(!isAffineBasis<2>({Vector<2>(0, 0), Vector<2>(infinity, 0), Vector<2>(0, 1)}));
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
        ControlCage<2> flat = cageAtRest<2>(triangle);
        flat.current[2] = flat.current[1];
        QVERIFY(!redefine<2>(flat, triangle));
        const Simplex<2> line{Vector<2>(0, 0), Vector<2>(1, 0), Vector<2>(2, 0)};
        QVERIFY(!redefine<2>(cageAtRest<2>(triangle), line));
    }

    void validity() {
        ControlCage<2> cage = cageAtRest<2>(triangle);
        QVERIFY(isValid(cage));
        cage.current[1] = cage.current[0];
        QVERIFY(isValid(cage));
        cage.current[1].x() = quietNaN;
        QVERIFY(!isValid(cage));
        cage = cageAtRest<2>(triangle);
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
        cage = polygonAtRest<2>({{0, 0}, {1, 1}, {1, 0}, {0, 1}}); // crosses itself
        QVERIFY(!isValid(cage));
        std::vector<Vector<2>> many;
        for (int j = 0; j < 65; ++j)
            many.emplace_back(std::cos(0.09 * j), std::sin(0.09 * j));
        QVERIFY(!isValid(polygonAtRest<2>(many)));
        many.pop_back();
        QVERIFY(isValid(polygonAtRest<2>(many)));
    }

    void aCageOfManyVerticesBends() {
        ControlCage<2> cage = polygonAtRest<2>(squareVertices);
        QVERIFY(!bends(cage));
        cage.current[2] = {2, 2};
        QVERIFY(bends(cage) && !isInvertible(cage) && isValid(cage));
        QVERIFY(!bake(system<2>(sierpinskiRight()), cage));
        QVERIFY(!redefine<2>(cage, triangle));
        const Placement placement(cage, Coordinates::Wachspress);
        QVERIFY(placement.bend() != nullptr);
        for (std::size_t j = 0; j < 4; ++j)
            QVERIFY((placement(cage.rest[j]) - cage.current[j]).norm() <= 1e-15);
        cage.deformation = Deformation::AffineFit;
        QVERIFY(!bends(cage) && isInvertible(cage));
        const Placement fit(cage, Coordinates::Wachspress);
        QVERIFY(fit.bend() == nullptr);
        QVERIFY((fit(Vector<2>(1, 1)) - Vector<2>(1.75, 1.75)).norm() <= 1e-14);
        const auto baked = bake(system<2>(sierpinskiRight()), cage);
        QVERIFY(baked && baked->cage.rest == baked->cage.current);
        QVERIFY((baked->cage.rest[2] - Vector<2>(1.75, 1.75)).norm() <= 1e-14);
        // An affine move of all vertices is no bend.
        cage.deformation = Deformation::Bend;
        for (auto& vertex : cage.current)
            vertex = affineMap(0.3, 1, -2, 0.7, 5, 6)(vertex);
        cage.current = cage.rest;
        for (auto& vertex : cage.current)
            vertex = affineMap(0.3, 1, -2, 0.7, 5, 6)(vertex);
        QVERIFY(!bends(cage) && isInvertible(cage) && bake(system<2>(sierpinskiRight()), cage));
    }

    void wachspressOnlyInsideAConvexCage() {
        const auto support = SupportFunction<2>::of(sierpinskiRight()); // in (0,0), (1,0), (0,1)
        const auto choice = [&](const std::vector<Vector<2>>& rest) {
            return suitableCoordinates(rest, &*support);
        };
        QCOMPARE(choice(squareVertices), Coordinates::Wachspress); // touches two edges
        QCOMPARE(choice({{0, 1}, {1, 1}, {1, 0}, {0, 0}}), Coordinates::Wachspress);
        QCOMPARE(choice({{0.01, 0}, {1, 0}, {1, 1}, {0, 1}}), Coordinates::MeanValue);  // a bit sticks out
        QCOMPARE(choice({{0, 0}, {2, 0}, {0.9, 0.9}, {0, 2}}), Coordinates::MeanValue); // notch
        QCOMPARE(choice({{0, 0}, {1, 0}, {2, 0}, {0, 2}}), Coordinates::MeanValue);     // straight corner
        QCOMPARE(suitableCoordinates(squareVertices, nullptr), Coordinates::MeanValue);
    }

    void flawsAreTold() {
        const auto flaw = [](const ControlCage<2>& cage) {
            return flawOf(cage, Placement(cage, Coordinates::MeanValue));
        };
        ControlCage<2> cage = polygonAtRest<2>(squareVertices);
        QCOMPARE(flaw(cage), CageFlaw::None);
        cage.current[2] = {1.5, 1.5};
        QCOMPARE(flaw(cage), CageFlaw::None);
        cage.current[2] = {0.4, 0.4};
        QVERIFY(flaw(cage) != CageFlaw::None);
        cage.current[2] = {-1, -1}; // turned inside out
        QCOMPARE(flaw(cage), CageFlaw::Folded);
        cage.current = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};
        QCOMPARE(flaw(cage), CageFlaw::Folded);
        cage = polygonAtRest<2>({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
        cage.current[0] = {-0.1, 0};
        QCOMPARE(flaw(cage), CageFlaw::Concave);
        cage = polygonAtRest<2>(squareVertices); // mirrored, but not folded
        for (auto& vertex : cage.current)
            vertex.x() = -vertex.x();
        cage.current[2].y() = 1.2;
        QCOMPARE(flaw(cage), CageFlaw::None);
        cage =
            *withVertexInserted(polygonAtRest<2>({{0, 0}, {1, 0}, {0, 1}}), 1, 0.5); // on its edge: no notch
        cage.current = squareVertices;
        QCOMPARE(flaw(cage), CageFlaw::None);
    }

    void verticesComeAndGo() {
        ControlCage<2> cage = polygonAtRest<2>(squareVertices);
        cage.current[1] = {2, 0};
        const auto more = withVertexInserted(cage, 3, 0.25);
        QVERIFY(more && more->rest.size() == 5);
        QCOMPARE(more->rest[4], Vector<2>(0, 0.75));
        const Vector<2> x(0.3, 0.6);
        // A vertex on an edge changes nothing by itself.
        QVERIFY((Placement(*more, Coordinates::MeanValue)(x) - Placement(cage, Coordinates::MeanValue)(x))
                    .norm() <= 1e-13);
        QCOMPARE(*withVertexRemoved(*more, 4), cage);
        QVERIFY(!withVertexRemoved(cageAtRest<2>(triangle), 0));
        const auto regular = regularPolygonNear(std::vector<Vector<2>>{{0, 0}, {1, 0}, {1.1, 1}, {0, 1}});
        QVERIFY(regular.has_value());
        for (std::size_t j = 0; j < 4; ++j) {
            const Vector<2> edge = (*regular)[(j + 1) % 4] - (*regular)[j];
            const Vector<2> next = (*regular)[(j + 2) % 4] - (*regular)[(j + 1) % 4];
            QVERIFY((next - Vector<2>(-edge.y(), edge.x())).norm() <= 1e-14);
            QVERIFY(((*regular)[j] - squareVertices[j]).norm() < 0.11);
        }
        QVERIFY(!regularPolygonNear(std::vector<Vector<2>>(4, Vector<2>(1, 1))));
    }
};

BARYCAGE_TEST(ControlCageTest);
#include "control_cage_test.moc"
