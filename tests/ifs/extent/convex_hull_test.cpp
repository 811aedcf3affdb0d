// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/extent/convex_hull.h"
#include "ifs/extent/extent.h"
#include "support/named_test.h"

#include <QtTest>

using namespace ifs;
using namespace canonical;

namespace {

using Points = std::vector<Vector<2>>;

ConvexHull hullOf(const Maps2& maps, double tolerance) {
    return convexHull(*SupportFunction<2>::of(maps), tolerance);
}
double perimeter(const Points& polygon) {
    double result = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k)
        result += (polygon[(k + 1) % polygon.size()] - polygon[k]).norm();
    return result;
}
// The same counter-clockwise polygon, whichever vertex comes first.
bool equal(const Points& found, Points expected, double tolerance) {
    for (std::size_t turn = 0; turn < expected.size(); ++turn) {
        if (std::ranges::equal(found, expected, [=](const Vector<2>& p, const Vector<2>& q) {
                return (p - q).norm() <= tolerance;
            }))
            return true;
        std::rotate(expected.begin(), expected.begin() + 1, expected.end());
    }
    return false;
}
// How far x is outside the polygon, measured across its edges.
double outside(const Points& polygon, const Vector<2>& x) {
    double result = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vector<2> edge = polygon[(k + 1) % polygon.size()] - polygon[k], offset = x - polygon[k];
        result = std::max(result, (edge.y() * offset.x() - edge.x() * offset.y()) / edge.norm());
    }
    return result;
}

// One linear part, many translations.
Maps2 copies(double cosine, double sine, std::initializer_list<Vector<2>> translations) {
    Maps2 maps;
    for (const auto& t : translations)
        maps.push_back(affineMap(cosine, -sine, sine, cosine, t.x(), t.y()));
    return maps;
}
// Whether the area of the hull may be this one, by what is said of the error.
bool mayHaveArea(const ConvexHull& hull, double area) {
    const double seam = hull.error * (perimeter(hull.vertices) + std::numbers::pi * hull.error);
    return hull.area <= area + 1e-12 && area <= hull.area + seam + 1e-12;
}

// Box and hull of usual tolerance, which hold an orbit.
void verifyTight(const Maps2& maps, Random& random) {
    const auto support = *SupportFunction<2>::of(maps);
    const auto box = boundingBox(support);
    const double diagonal = (box.max - box.min).norm();
    QVERIFY2(box.error <= 1e-11 * diagonal, qPrintable(QString::number(box.error / diagonal)));
    const auto hull = convexHull(support, 1e-6 * diagonal);
    QVERIFY2(hull.error <= 1e-6 * diagonal, qPrintable(QString::number(hull.error / diagonal)));
    for (const auto& x : orbit<2>(maps, 2000, random))
        QVERIFY(outside(hull.vertices, x) <= hull.error + 1e-12 * diagonal);
}

} // namespace

class ConvexHullTest : public QObject {
    Q_OBJECT

private slots:
    // Products of lengths underflow there, lengths do not.
    void tinyUnits() {
        for (const int exponent : {-300, -520, -600, -900}) {
            const auto hull = hullOf(scaled(sierpinskiRight(), std::ldexp(1, exponent)), 0);
            QCOMPARE(hull.vertices.size(), std::size_t(3));
            QVERIFY(hull.error > 0 && hull.error < std::ldexp(1e-9, exponent));
            QVERIFY(areaError(hull) > 0);
            QVERIFY(std::abs(std::ldexp(.5, 2 * exponent) - hull.area) <= areaError(hull));
        }
    }

    void exactPolygons() {
        QVERIFY(equal(hullOf(sierpinskiRight(), 0).vertices, {{0, 0}, {1, 0}, {0, 1}}, 1e-12));
        const auto curve = hullOf(koch(), 0);
        QVERIFY(equal(curve.vertices, {{0, 0}, {1, 0}, {.5, std::sqrt(3) / 6}}, 1e-12));
        QVERIFY(std::abs(curve.area - std::sqrt(3) / 12) < 1e-12);
        const auto octagon = hullOf(levy(), 0);
        QVERIFY(equal(octagon.vertices,
                      {{1.5, .5}, {1, 1}, {0, 1}, {-.5, .5}, {-.5, 0}, {-.25, -.25}, {1.25, -.25}, {1.5, 0}},
                      1e-12));
        QVERIFY(std::abs(octagon.area - 35. / 16) < 1e-12);
        QVERIFY(std::abs(perimeter(octagon.vertices) - 3.5 - 1.5 * std::sqrt(2)) < 1e-12);
        const auto decagon = hullOf(heighway(), 0);
        QVERIFY(equal(decagon.vertices,
                      {{7. / 6, 0},
                       {5. / 6, .5},
                       {2. / 3, 2. / 3},
                       {0, 2. / 3},
                       {-1. / 3, 1. / 3},
                       {-1. / 3, 0},
                       {-1. / 6, -1. / 6},
                       {2. / 3, -1. / 3},
                       {1, -1. / 3},
                       {7. / 6, -1. / 6}},
                      1e-12));
        QVERIFY(std::abs(decagon.area - 7. / 6) < 1e-12);
        const auto twins = hullOf(twin(), 0);
        QVERIFY(equal(twins.vertices,
                      {{4. / 3, 0},
                       {2. / 3, 2. / 3},
                       {0, 2. / 3},
                       {-1. / 3, 1. / 3},
                       {-1. / 3, 0},
                       {1. / 3, -2. / 3},
                       {1, -2. / 3},
                       {4. / 3, -1. / 3}},
                      1e-12));
        for (const auto& hull : {curve, octagon, decagon, twins})
            QVERIFY(hull.error <= 1e-10);
    }

    void knownAreas() {
        const auto tree = hullOf(maple(), 1e-12);
        QVERIFY(std::abs(tree.area - 35.754947908201) < 1e-10);
        QVERIFY(std::abs(perimeter(tree.vertices) - 22.338540357728) < 1e-10);
        QVERIFY(tree.error <= 1e-10);
        const auto arch = hullOf(flower(), 1e-8);
        QVERIFY(std::abs(arch.area - 6.73505893) < 1e-7);
        QVERIFY(std::abs(perimeter(arch.vertices) - 10.9600958) < 1e-6);
        const auto leaf = hullOf(fern(), 1e-4);
        QVERIFY(std::abs(leaf.area - 31.31250) < 2e-3);
        QVERIFY(std::abs(perimeter(leaf.vertices) - 23.69498) < 2e-3);
    }

    // Sums of regular polygons and of the same half a step farther, with edges that rounding alone keeps from
    // being vertical.
    void verticalEdges() {
        const auto knotwork =
            copies(0.3535533905932738, 0.35355339059327373, {{0, 0}, {.5, 0}, {0, .5}, {.5, .5}});
        const auto decagonFlake = copies(0.2628655560595668, 0.08541019662496845,
                                         {{0.6881909602355867, 0.22360679774997894},
                                          {0.42532540417601994, 0.5854101966249684},
                                          {0, 0.7236067977499789},
                                          {-0.4253254041760199, 0.5854101966249684},
                                          {-0.6881909602355867, 0.22360679774997902},
                                          {-0.6881909602355868, -0.22360679774997885},
                                          {-0.42532540417602005, -0.5854101966249684},
                                          {0, -0.7236067977499789},
                                          {0.4253254041760198, -0.5854101966249685},
                                          {0.6881909602355867, -0.2236067977499791},
                                          {0, 0}});
        // Radii R and r: n/2·(R² + r²)·sin 2φ + 2n·R·r·sin φ, where φ = π/n.
        const auto areaOfSum = [](int n, double outer, double inner) {
            const double half = std::numbers::pi / n;
            return n / 2. * (outer * outer + inner * inner) * std::sin(2 * half) +
                   2 * n * outer * inner * std::sin(half);
        };
        const double square = std::sqrt(2) / 3; // (√2/4) / (1 − ¼)
        const double ratio = std::hypot(0.2628655560595668, 0.08541019662496845),
                     decagon = 0.7236067977499789 / (1 - ratio * ratio);
        for (const double tolerance : {1e-4, 1e-6, 1e-12}) {
            QVERIFY(mayHaveArea(hullOf(knotwork, tolerance), areaOfSum(4, square, square / 2)));
            QVERIFY(mayHaveArea(hullOf(decagonFlake, tolerance), areaOfSum(10, decagon, ratio * decagon)));
        }
    }

    void verticesOfMaple() {
        const ConvexHull hull = hullOf(maple(), 1e-12);
        const Points& vertices = hull.vertices;
        const Points listed{
            {3.3442144495405580, 0.3195607551473931},  {3.2287032507195057, 1.7405960934671075},
            {2.0446678609049159, 4.0323158811861332},  {-1.7529254544172583, 4.3551003115451404},
            {-3.3000939564735311, 1.6665529554982757}, {-0.1148640517020626, -3.1730509611301708},
            {3.0772449473575674, -0.3266784748003194}, {3.3434299800731399, 0.2568751496483599}};
        for (const auto& point : listed)
            QVERIFY(std::ranges::any_of(vertices,
                                        [&](const Vector<2>& v) { return (v - point).norm() < 1e-11; }));
        const Vector<2> top(7. / 39, 350. / 69); // vertices accumulate there
        QVERIFY(outside(vertices, top) <= hull.error && hull.error < 1e-10);
        QVERIFY(std::ranges::any_of(vertices, [&](const Vector<2>& v) { return (v - top).norm() < 1e-6; }));
    }

    void certificateHoldsForTheOrbit() {
        Random random(1);
        for (int n = 0; n < 300; ++n) {
            const auto maps = randomContractions<2>(random, 2 + int(random() % 4));
            const auto support = *SupportFunction<2>::of(maps);
            const double tolerance = 1e-4 * support.radius(), s = support.contractivity();
            const auto hull = convexHull(support, tolerance);
            QVERIFY(hull.error <= tolerance * (1 + 2 * s / (1 - s)) + 1e-10);
            if (hull.vertices.size() < 3) continue;
            for (const auto& x : orbit<2>(maps, 300, random))
                QVERIFY(outside(hull.vertices, x) <= hull.error + 1e-12 * support.radius());
        }
    }

    void longOrbitStaysInside() {
        Random random(2);
        const auto hull = hullOf(maple(), 1e-12);
        for (const auto& x : orbit<2>(maple(), 1'000'000, random))
            QVERIFY(outside(hull.vertices, x) <= hull.error);
    }

    void pointsAndSegments() {
        const auto point = hullOf({affineMap(.5, 0, 0, .5, 1, 2)}, 0);
        QCOMPARE(point.vertices.size(), std::size_t(1));
        QCOMPARE(point.area, 0.0);
        const auto segment = hullOf({affineMap(.5, 0, 0, .5, 0, 0), affineMap(.5, 0, 0, .5, 1, 1)}, 0);
        QVERIFY(equal(segment.vertices, {{0, 0}, {2, 2}}, 1e-12));
        QVERIFY(segment.error < 1e-10);
    }

    void eventuallyContractiveSystem() {
        Random random(3);
        const auto support = *SupportFunction<2>::of(eventual());
        const auto hull = convexHull(support, 1e-6);
        QVERIFY(std::isfinite(hull.error) && hull.error < 1e-2);
        for (const auto& x : orbit<2>(eventual(), 10'000, random))
            QVERIFY(outside(hull.vertices, x) <= std::min(hull.error, 1.1e-6));
    }

    // Many maps, of which one is slow: thousands of words are nearly as far out as the farthest.
    void manyMapsAreTight() {
        Random random(4);
        for (int n = 0; n < 40; ++n) {
            auto maps = randomContractions<2>(random, 12 + int(random() % 21));
            maps.front().linear *= 0.97 / spectralNorm<2>(maps.front().linear);
            verifyTight(maps, random);
        }
    }

    // Up to 32 maps with norms up to 0.98.
    void anyNumberOfMapsIsTight() {
        Random random(9);
        for (int n = 0; n < 40; ++n)
            verifyTight(randomContractions<2>(random, 2 + int(random() % 31), 0.98), random);
    }

    // Lines that differed in the last digits replaced each other for ever.
    void theFinestHullEnds() {
        const std::vector<AffineMap<2>> maps{
            affineMap(-0.279305, 0.41855, 0.0471545, -0.115376, -0.724803, -0.909322),
            affineMap(0.348231, 0.0281437, -0.687944, -0.52939, -0.731557, 0.907223)};
        const auto support = *SupportFunction<2>::of(maps);
        const auto hull = convexHull(support, 1e-12 * support.radius());
        QVERIFY(hull.error <= 1e-9 * support.radius());
    }

    void aHullThatIsStoppedIsNone() {
        std::stop_source stopped;
        stopped.request_stop();
        const auto support = *SupportFunction<2>::of(maple());
        QVERIFY(!convexHull(support, 1e-9, stopped.get_token()));
        // The outline that was begun is coarse, and right: what comes later is as sharp as ever.
        const auto box = boundingBox(support), usual = boundingBox(*SupportFunction<2>::of(maple()));
        QVERIFY((box.min - usual.min).norm() <= box.error + usual.error);
        QVERIFY((box.max - usual.max).norm() <= box.error + usual.error);
        const auto hull = convexHull(support, 1e-9, {});
        QVERIFY(hull && hull->error <= 1e-9);
        QVERIFY(std::abs(hull->area - hullOf(maple(), 1e-9).area) < 1e-6);
    }
};

BARYCAGE_TEST(ConvexHullTest);
#include "convex_hull_test.moc"
