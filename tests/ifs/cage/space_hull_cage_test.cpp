// SPDX-License-Identifier: MIT
#include "ifs/cage/space_hull_cage.h"

#include "ifs/cage/cage_surface.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>

using namespace ifs;

namespace {

using Maps = std::vector<AffineMap<3>>;

// Halves towards the corners of the regular octahedron of radius 1.
Maps octahedronFlake() {
    Maps maps;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {0.5, -0.5})
            maps.push_back({0.5 * Matrix<3>::Identity(), side * Vector<3>::Unit(axis)});
    return maps;
}

Maps cubeOfEight() {
    Maps maps;
    for (int k = 0; k < 8; ++k)
        maps.push_back({0.5 * Matrix<3>::Identity(), Vector<3>(k & 1, k >> 1 & 1, k >> 2) / 2});
    return maps;
}

// Whether the support function is nowhere beyond that of the points.
bool contains(const std::vector<Vector<3>>& points, const SupportFunction<3>& support) {
    for (int i = 0; i < 400; ++i) {
        const double y = 1 - (2 * i + 1) / 400.0;
        const double ring = std::sqrt(1 - y * y);
        const Vector<3> u(ring * std::cos(2.4 * i), y, ring * std::sin(2.4 * i));
        double most = -HUGE_VAL;
        for (const Vector<3>& point : points)
            most = std::max(most, u.dot(point));
        if (support(u).value > most + 1e-9) return false;
    }
    return true;
}

} // namespace

class SpaceHullCageTest : public QObject {
    Q_OBJECT

private slots:
    void aroundACube() {
        const auto support = *SupportFunction<3>::of(cubeOfEight());
        const auto box = boxCage(support, 1e-9);
        for (int k = 0; k < 8; ++k)
            QVERIFY((box[std::size_t(k)] - Vector<3>(k & 1, k >> 1 & 1, k >> 2)).norm() < 1e-8);
        QCOMPARE(hullCage(support, 24, 1e-9).size(), std::size_t(8)); // nothing can be cut
        const auto octahedron = octahedronCage(support, 1e-9);
        QCOMPARE(octahedron.size(), std::size_t(6));
        QVERIFY((octahedron[1] - Vector<3>(2, .5, .5)).norm() < 1e-8);
        QVERIFY(contains(octahedron, support));
    }

    // The octahedron has a sixth of its box: each of eight cuts takes its share.
    void anOctahedronIsFoundInItsBox() {
        const auto support = *SupportFunction<3>::of(octahedronFlake());
        for (const int corners : {8, 10, 12, 16, 20, 24}) {
            const auto cage = hullCage(support, corners, 1e-9);
            QVERIFY(int(cage.size()) <= corners && cage.size() >= 6);
            QVERIFY(convexSurface(cage));
            QVERIFY(contains(cage, support));
        }
    }

    void whatIsFlatHasACageAllTheSame() {
        Maps maps;
        for (const Vector<3>& at : {Vector<3>(0, 0, 0), Vector<3>(.5, 0, 0), Vector<3>(0, .5, 0)})
            maps.push_back({0.5 * Matrix<3>::Identity(), at});
        const auto support = *SupportFunction<3>::of(maps);
        QVERIFY(convexSurface(boxCage(support, 1e-9)));
        const auto hull = hullCage(support, 24, 1e-9);
        QVERIFY(convexSurface(hull) && contains(hull, support));
    }
};

BARYCAGE_TEST(SpaceHullCageTest);
#include "space_hull_cage_test.moc"
