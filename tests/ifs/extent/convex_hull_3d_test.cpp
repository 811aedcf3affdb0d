// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/deadline.h"
#include "ifs/extent/convex_hull.h"
#include "ifs/extent/convex_hull_3d.h"
#include "support/named_test.h"
#include "support/processor_timer.h"

#include <QtTest>

#include <Eigen/Geometry>

#include <map>

using namespace ifs;
using namespace canonical;

namespace {

ConvexHull3 hullOf(const Maps3& maps, double tolerance) {
    return convexHull(*SupportFunction<3>::of(maps), tolerance);
}

// How far x lies outside the half spaces of the facets.
double outside(const ConvexHull3& hull, const Vector<3>& x) {
    double farthest = -infinity;
    for (const auto& facet : hull.facets) {
        const auto corner = [&](std::size_t k) { return hull.vertices[std::size_t(facet[k])]; };
        const Vector<3> normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
        if (normal.norm() > 1e-13) farthest = std::max(farthest, normal.normalized().dot(x - corner(0)));
    }
    return farthest;
}

// Every edge is used once in each direction, and V − E + F = 2.
bool isClosed(const ConvexHull3& hull) {
    std::map<std::pair<int, int>, int> edges;
    for (const auto& facet : hull.facets)
        for (std::size_t k = 0; k < 3; ++k)
            ++edges[{facet[k], facet[(k + 1) % 3]}];
    return std::ranges::all_of(edges,
                               [&](const auto& edge) {
                                   const auto back = edges.find({edge.first.second, edge.first.first});
                                   return edge.second == 1 && back != edges.end();
                               }) &&
           hull.vertices.size() + hull.facets.size() == edges.size() / 2 + 2;
}

bool hasVertex(const ConvexHull3& hull, const Vector<3>& x, double tolerance) {
    return std::ranges::any_of(hull.vertices, [&](const auto& v) { return (v - x).norm() <= tolerance; });
}

} // namespace

class ConvexHull3dTest : public QObject {
    Q_OBJECT

private slots:
    void exactPolytopes() {
        const auto tetra = hullOf(tetrahedron(), 1e-9);
        QCOMPARE(tetra.vertices.size(), std::size_t(4));
        QVERIFY(hasVertex(tetra, {0, 0, 0}, 1e-12) && hasVertex(tetra, {0, 1, 0}, 1e-12));
        QVERIFY(isClosed(tetra) && std::abs(tetra.volume - 1. / 6) < 1e-12 && tetra.error < 1e-10);
        const auto box = hullOf(cube(), 1e-9);
        QCOMPARE(box.vertices.size(), std::size_t(8));
        for (int corner = 0; corner < 8; ++corner)
            QVERIFY(hasVertex(box, Vector<3>(corner & 1, corner >> 1 & 1, corner >> 2 & 1), 1e-12));
        QVERIFY(isClosed(box) && std::abs(box.volume - 1) < 1e-12 && box.error < 1e-10);
    }

    // Its maps contract in coordinates of which the best found turn the solid inside out.
    void facetsFaceOutwards() {
        Matrix<3> first, second;
        first << .1, .2, -.1, .3, -.4, .6, .5, .6, .6;
        second << -.3, .6, .4, 0, -.6, .7, -.4, -.5, .1;
        const Maps3 maps{map3(first, {2, 3, 2}), map3(second, {3, 3, 1})};
        const auto hull = hullOf(maps, 1e-6);
        Random random(4);
        for (const auto& x : orbit<3>(maps, 5000, random))
            QVERIFY(outside(hull, x) <= hull.error);
        QVERIFY(isClosed(hull) && hull.volume > 1);
    }

    // Products of lengths underflow there, lengths do not.
    void tinyUnits() {
        for (const int exponent : {-150, -300, -500, -900}) {
            const auto hull = hullOf(scaled(tetrahedron(), std::ldexp(1, exponent)), 0);
            QCOMPARE(hull.vertices.size(), std::size_t(4));
            QVERIFY(hull.error > 0 && hull.error < std::ldexp(1e-9, exponent));
            const double excess = std::ldexp(1. / 6, 3 * exponent) - hull.volume;
            QVERIFY(volumeError(hull) > 0 && std::abs(excess) <= volumeError(hull));
        }
    }

    void fernInSpace() {
        Random random(1);
        const auto hull = hullOf(fern3(), 1e-2);
        QVERIFY(isClosed(hull) && hull.volume > 24 && hull.volume < 26 && hull.error <= 1e-2);
        double highest = 0;
        for (const auto& x : orbit<3>(fern3(), 20'000, random))
            QVERIFY(outside(hull, x) <= hull.error);
        for (const auto& vertex : hull.vertices)
            highest = std::max(highest, vertex.y());
        QVERIFY(std::abs(highest - 7.997725100771707) < 1e-9);
    }

    // What is asked for is reached, with no more corners than it takes.
    void theToleranceIsMet() {
        for (const double tolerance : {1e-1, 1e-2, 1e-3}) {
            const auto hull = hullOf(fern3(), tolerance);
            QVERIFY(isClosed(hull) && hull.error <= tolerance);
            QVERIFY(hull.vertices.size() < std::size_t(150 / std::sqrt(tolerance)));
            Random random(3);
            for (const auto& x : orbit<3>(fern3(), 2000, random))
                QVERIFY(outside(hull, x) <= hull.error);
        }
        // A tolerance beyond reach ends as well, and the error says so.
        const auto hull = hullOf(fern3(), 1e-9);
        QVERIFY(hull.error > 1e-9 && hull.error < 1e-3);
    }

    void certificateHoldsForTheOrbit() {
        Random random(2);
        for (int n = 0; n < 30; ++n) {
            const auto maps = randomContractions<3>(random, 3, 0.6);
            const auto support = *SupportFunction<3>::of(maps);
            const auto hull = convexHull(support, 1e-2 * support.radius());
            QVERIFY(hull.error <= 1e-2 * support.radius());
            if (hull.volume < 1e-6 * std::pow(support.radius(), 3)) continue;
            QVERIFY(isClosed(hull));
            for (const auto& x : orbit<3>(maps, 300, random))
                QVERIFY(outside(hull, x) <= hull.error + 1e-12 * support.radius());
        }
    }

    void flatSystems() {
        const Matrix<3> half = Matrix<3>::Identity() / 2;
        const auto point = hullOf({map3(half, {1, 2, 3})}, 1e-9);
        QCOMPARE(point.vertices.size(), std::size_t(1));
        QVERIFY(hasVertex(point, {2, 4, 6}, 1e-12) && point.facets.empty() && point.volume == 0);
        const auto origin = hullOf({map3(half, {0, 0, 0})}, 0); // of no size, at no distance
        QVERIFY(origin.vertices.size() == 1 && origin.error == 0);
        const auto segment = hullOf({map3(half, {0, 0, 0}), map3(half, {1, 1, 1})}, 1e-9);
        QCOMPARE(segment.vertices.size(), std::size_t(2));
        QVERIFY(hasVertex(segment, {0, 0, 0}, 1e-12) && hasVertex(segment, {2, 2, 2}, 1e-12));
        const auto gasket =
            hullOf({map3(half, {0, 0, 0}), map3(half, {1, 0, 0}), map3(half, {0, 1, 1})}, 1e-9);
        QCOMPARE(gasket.vertices.size(), std::size_t(3));
        QVERIFY(hasVertex(gasket, {0, 2, 2}, 1e-12) && gasket.facets.size() == 1 && gasket.volume == 0);
        for (const auto& hull : {point, segment, gasket})
            QVERIFY(hull.error < 1e-9);
    }

    // The hull of what lies in a plane is that in the plane, and as well known, wherever the plane stands.
    void aLiftedSystemHasItsHullInThePlane() {
        Maps3 maps;
        const Matrix<3> turn = Eigen::AngleAxisd(0.7, Vector<3>(1, 2, 3).normalized()).toRotationMatrix();
        for (const auto& map : fern()) {
            Matrix<3> linear = Matrix<3>::Identity() / 2;
            linear.topLeftCorner<2, 2>() = map.linear;
            maps.push_back(map3(turn * linear * turn.transpose(),
                                turn * Vector<3>(map.translation.x(), map.translation.y(), 0)));
        }
        const auto support = *SupportFunction<3>::of(maps);
        const auto hull = convexHull(support, 1e-5 * support.radius());
        QVERIFY2(hull.error <= 2e-5 * support.radius(), qPrintable(QString::number(hull.error)));
        QCOMPARE(hull.volume, 0.0);
        double area = 0;
        for (const auto& [a, b, c] : hull.facets)
            area += (hull.vertices[std::size_t(b)] - hull.vertices[std::size_t(a)])
                        .cross(hull.vertices[std::size_t(c)] - hull.vertices[std::size_t(a)])
                        .norm() /
                    2;
        const auto flat = convexHull(*SupportFunction<2>::of(fern()), 1e-5 * support.radius());
        QVERIFY(std::abs(area - flat.area) <= areaError(flat) + 1e-3 * flat.area);
        Random random(3);
        for (const auto& x : orbit<3>(maps, 300, random)) {
            double reach = 0; // beyond the hull, along some directions in the plane
            for (int k = 0; k < 16; ++k) {
                const Vector<3> u = turn * Vector<3>(std::cos(k * 0.4), std::sin(k * 0.4), 0);
                double farthest = -infinity;
                for (const auto& vertex : hull.vertices)
                    farthest = std::max(farthest, u.dot(vertex));
                reach = std::max(reach, u.dot(x) - farthest);
            }
            QVERIFY(reach <= hull.error + 1e-12 * support.radius());
        }
    }

    void aHullThatIsStoppedIsNone() {
        std::stop_source stopped;
        stopped.request_stop();
        const auto support = *SupportFunction<3>::of(fern3());
        QVERIFY(!convexHull(support, 1e-2, stopped.get_token()));
        QVERIFY(convexHull(support, 1e-2, {})->error <= 1e-2);
    }

    // Half-way as well as at the beginning: a hull to this tolerance takes far longer than that.
    void aHullIsStoppedWhileItIsMade() {
        const auto support = *SupportFunction<3>::of(fern3());
        const Deadline deadline(Deadline::Time(0.02));
        const support::ProcessorTimer timer;
        QVERIFY(!convexHull(support, 1e-9 * support.radius(), deadline.token()));
        QVERIFY2(timer.elapsed() < 20'000, qPrintable(QString::number(timer.elapsed())));
    }
};

BARYCAGE_TEST(ConvexHull3dTest);
#include "convex_hull_3d_test.moc"
