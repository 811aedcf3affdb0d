// SPDX-License-Identifier: MIT
#include "ifs/cage/cage_surface.h"
#include "support/named_test.h"

#include <Eigen/Geometry>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <random>

using namespace ifs;

namespace {

using Points = std::vector<Vector<3>>;

Points cube() {
    Points corners;
    for (int k = 0; k < 8; ++k)
        corners.emplace_back(k & 1, k >> 1 & 1, k >> 2);
    return corners;
}

Points octahedron() {
    Points corners;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {1.0, -1.0})
            corners.emplace_back(side * Vector<3>::Unit(axis));
    return corners;
}

double largestDifference(const std::vector<double>& a, const std::vector<double>& b) {
    double most = a.size() == b.size() ? 0 : 1;
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
        most = std::max(most, std::abs(a[k] - b[k]));
    return most;
}

} // namespace

class CageSurfaceTest : public QObject {
    Q_OBJECT

private slots:
    void facesAreWholeAndTurnOutwards() {
        const auto surface = convexSurface(cube());
        QVERIFY(surface);
        QCOMPARE(surface->faces.size(), std::size_t(6));
        QCOMPARE(surface->edges().size(), std::size_t(12));
        const Points corners = cube();
        const auto at = [&](int k) { return corners[std::size_t(k)]; };
        for (const auto& face : surface->faces) {
            QCOMPARE(face.size(), std::size_t(4));
            const Vector<3> normal = (at(face[1]) - at(face[0])).cross(at(face[2]) - at(face[0]));
            QVERIFY(normal.dot(at(face[0]) - Vector<3>(.5, .5, .5)) > 0);
        }
        QCOMPARE(convexSurface(octahedron())->faces.size(), std::size_t(8));
        QCOMPARE(convexSurface(octahedron())->edges().size(), std::size_t(12));
    }

    void whatIsNoConvexPolyhedronHasNone() {
        Points inside = cube();
        inside.emplace_back(.5, .4, .3);
        QVERIFY(!convexSurface(inside));
        Points onFace = cube();
        onFace.emplace_back(.5, .5, 1);
        QVERIFY(!convexSurface(onFace));
        Points onEdge = cube();
        onEdge.emplace_back(.5, 0, 0);
        QVERIFY(!convexSurface(onEdge));
        Points twice = cube();
        twice.push_back(twice[3]);
        QVERIFY(!convexSurface(twice));
        Points flat;
        for (const Vector<3>& corner : cube())
            flat.emplace_back(corner.x(), corner.y() + 2 * corner.x(), 0);
        QVERIFY(!convexSurface(flat));
        QVERIFY(!convexSurface(Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
        QVERIFY(!convexSurface(Points(6, Vector<3>(1, 2, 3))));
        Points infinite = cube();
        infinite[2].x() = HUGE_VAL;
        QVERIFY(!convexSurface(infinite));
    }

    // The paper's numbers for the octahedron, and an eighth for every corner of a cube at its centre.
    void oracles() {
        const CageDeformation octa(octahedron(), octahedron());
        QVERIFY(largestDifference(octa.coordinates({.1, .2, .3}),
                                  {0.186524520073729, 0.086524520073729, 0.263924386724053, 0.063924386724052,
                                   0.349551093202218, 0.049551093202219}) < 1e-14);
        QVERIFY(largestDifference(octa.coordinates(Vector<3>::Zero()), std::vector<double>(6, 1.0 / 6)) <
                1e-15);
        const CageDeformation box(cube(), cube());
        QVERIFY(largestDifference(box.coordinates({.5, .5, .5}), std::vector<double>(8, 0.125)) < 1e-15);
        const Points tetrahedron{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        const CageDeformation simplex(tetrahedron, tetrahedron);
        QVERIFY(largestDifference(simplex.coordinates({.2, .3, .1}), {.4, .2, .3, .1}) < 1e-14);
    }

    void coordinatesReproducePointsAndCorners() {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> share(0, 1);
        for (const Points& corners : {cube(), octahedron()}) {
            const CageDeformation cage(corners, corners);
            for (int n = 0; n < 200; ++n) {
                Vector<3> x = Vector<3>::Zero();
                double all = 0;
                std::vector<double> weights;
                for (std::size_t j = 0; j < corners.size(); ++j)
                    all += weights.emplace_back(share(random));
                for (std::size_t j = 0; j < corners.size(); ++j)
                    x += weights[j] / all * corners[j];
                const auto lambda = cage.coordinates(x);
                Vector<3> again = Vector<3>::Zero();
                double sum = 0;
                for (std::size_t j = 0; j < corners.size(); ++j) {
                    QVERIFY(lambda[j] >= -1e-15);
                    again += lambda[j] * corners[j];
                    sum += lambda[j];
                }
                QVERIFY(std::abs(sum - 1) < 1e-14 && (again - x).norm() < 1e-13);
            }
            for (std::size_t j = 0; j < corners.size(); ++j) {
                std::vector<double> one(corners.size());
                one[j] = 1;
                QVERIFY(largestDifference(cage.coordinates(corners[j]), one) < 1e-12);
            }
        }
    }

    void whatTheCubeIsSymmetricUnderTheCoordinatesAre() {
        const CageDeformation cage(cube(), cube());
        const auto here = cage.coordinates({.2, .3, .4});
        const auto mirrored = cage.coordinates({.8, .3, .4});
        const auto swapped = cage.coordinates({.3, .2, .4});
        for (std::size_t k = 0; k < 8; ++k) {
            QVERIFY(std::abs(here[k] - mirrored[k ^ 1]) < 1e-14);
            const std::size_t other = (k & 4) | (k & 1) << 1 | (k & 2) >> 1;
            QVERIFY(std::abs(here[k] - swapped[other]) < 1e-14);
        }
    }

    void anAffineImageIsTakenByThatMap() {
        AffineMap<3> map;
        map.linear << 1, 2, 0, -1, 1, .5, 0, .3, 2;
        map.translation << 3, -2, 1;
        Points image;
        for (const Vector<3>& corner : cube())
            image.push_back(map(corner));
        const CageDeformation cage(cube(), image);
        for (const Vector<3>& x : {Vector<3>(.1, .7, .3), Vector<3>(.5, .5, 1), Vector<3>(2, 3, -1)})
            QVERIFY((cage(x) - map(x)).norm() < 1e-13);
    }

    void aPulledCornerIsFollowed() {
        Points pulled = cube();
        pulled[7] += Vector<3>(.5, .25, 1);
        const CageDeformation cage(cube(), pulled);
        QVERIFY((cage(cube()[7]) - pulled[7]).norm() < 1e-12);
        QVERIFY((cage(cube()[0]) - pulled[0]).norm() < 1e-12);
        QVERIFY((cage({.5, .5, .5}) - Vector<3>(.5 + .5 / 8, .5 + .25 / 8, .5 + 1.0 / 8)).norm() < 1e-14);
        QVERIFY((cage({.5, 0, 0}) - Vector<3>(.5, 0, 0)).norm() < 1e-12); // linear along edges
    }
};

BARYCAGE_TEST(CageSurfaceTest);
#include "cage_surface_test.moc"
