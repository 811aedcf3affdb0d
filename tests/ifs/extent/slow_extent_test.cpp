// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/extent/convex_hull.h"
#include "ifs/extent/convex_hull_3d.h"
#include "ifs/extent/extent.h"
#include "ifs/extent/polygon.h"
#include "support/named_test.h"

#include <QtTest>

using namespace ifs;
using namespace canonical;

namespace {

// Two to four maps whose longest singular value is within the range.
template <int Dim> std::vector<AffineMap<Dim>> slowMaps(Random& random, double least, double most) {
    std::vector<AffineMap<Dim>> maps(2 + random() % 3);
    for (auto& map : maps) {
        map.linear = randomMatrix<Dim>(random);
        map.linear *= uniform(random, least, most) / spectralNorm<Dim>(map.linear);
        map.translation = randomVector<Dim>(random, 3);
    }
    return maps;
}

} // namespace

// Attractors of maps that hardly contract, whose pieces overlap a great deal.
class SlowExtentTest : public QObject {
    Q_OBJECT

private slots:
    // Their boxes were off by up to 0.4 %, their hulls by a third of their size.
    void inThePlane() {
        for (const auto& [seed, skipped] : {std::pair{2U, 3}, {22U, 24}}) {
            Random random(seed);
            for (int n = 0; n < skipped; ++n)
                slowMaps<2>(random, .97, .999);
            const Maps2 maps = slowMaps<2>(random, .97, .999);
            const auto support = SupportFunction<2>::of(maps);
            QVERIFY(support.has_value());
            const auto box = boundingBox(*support);
            const double size = (box.max - box.min).norm();
            QVERIFY(box.error <= 1e-6 * size);
            const auto hull = convexHull(*support, 1e-6 * size);
            QVERIFY(hull.error <= 1e-5 * size);
            for (const Vector<2>& x : orbit<2>(maps, 20'000, random)) {
                QVERIFY((box.min - x).maxCoeff() <= box.error + 1e-12 * size);
                QVERIFY((x - box.max).maxCoeff() <= box.error + 1e-12 * size);
                QVERIFY(distanceToConvex(hull.vertices, x) <= hull.error + 1e-12 * size);
            }
        }
    }

    // Their norms are polytopes, and words of theirs hardly contract: boxes were off by many times their
    // size.
    void nearlyIsometricTiles() {
        const double q = 0.99985;
        const Matrix<2> shear{{q, -0.5 * q}, {0, 0.5 * q}}, turn{{-0.5 * q, -q}, {0.5 * q, 0}};
        const Matrix<2> back{{0.5 * q, -q}, {0.5 * q, 0}}, other{{0, -0.5 * q}, {q, 0.5 * q}};
        Random random(7);
        for (const auto& [first, second] : {std::pair{shear, turn}, {back, other}, {turn, back}}) {
            const Maps2 maps{{first, randomVector<2>(random, 5)}, {second, randomVector<2>(random, 5)}};
            const auto support = SupportFunction<2>::of(maps);
            QVERIFY(support.has_value());
            const auto box = boundingBox(*support);
            const double size = (box.max - box.min).norm();
            QVERIFY2(box.error <= 1e-9 * size, qPrintable(QString::number(box.error / size)));
            const auto hull = convexHull(*support, 1e-6 * size);
            QVERIFY(hull.error <= 2e-6 * size);
            for (const Vector<2>& x : orbit<2>(maps, 20'000, random)) {
                QVERIFY((box.min - x).maxCoeff() <= box.error + 1e-12 * size);
                QVERIFY((x - box.max).maxCoeff() <= box.error + 1e-12 * size);
                QVERIFY(distanceToConvex(hull.vertices, x) <= hull.error + 1e-12 * size);
            }
        }
    }

    // In coordinates that stretch a thousand times, where each map contracts, and not in those where it
    // contracts most, which stretch without bound: the box had an error of 10²³ sizes.
    void slowTriangles() {
        const Maps2 maps{affineMap(.388184, 85.9751, 0, .507588, -4.03601, 3.52886),
                         affineMap(.252498, 54.5615, 0, .999976, 1.62805, 4.1714)};
        const auto support = SupportFunction<2>::of(maps);
        QVERIFY(support.has_value());
        const auto box = boundingBox(*support);
        const double size = (box.max - box.min).norm();
        QVERIFY2(box.error <= 1e-6 * size, qPrintable(QString::number(box.error / size)));
        Random random(3);
        for (const Vector<2>& x : orbit<2>(maps, 20'000, random)) {
            QVERIFY((box.min - x).maxCoeff() <= box.error + 1e-9 * size);
            QVERIFY((x - box.max).maxCoeff() <= box.error + 1e-9 * size);
        }
    }

    // Boxes were off by up to 9 %.
    void inSpace() {
        Random random(25);
        for (int n = 0; n < 12; ++n) {
            const auto maps = slowMaps<3>(random, .97, .999);
            const auto support = SupportFunction<3>::of(maps);
            QVERIFY(support.has_value());
            const auto box = boundingBox(*support);
            const double size = (box.max - box.min).norm();
            QVERIFY2(box.error <= 1e-6 * size, qPrintable(QString::number(n)));
            const auto hull = convexHull(*support, 1e-2 * size);
            QVERIFY2(hull.error <= 2e-2 * size, qPrintable(QString::number(n)));
        }
    }

    // Its farthest points in 26 directions are three, in whose plane the hull was thought to end.
    void aNeedleInSpace() {
        Random random(25);
        for (int n = 0; n < 22; ++n)
            slowMaps<3>(random, .97, .999);
        const auto support = *SupportFunction<3>::of(slowMaps<3>(random, .97, .999));
        const auto box = boundingBox(support);
        const double size = (box.max - box.min).norm();
        const auto hull = convexHull(support, 1e-3 * size);
        QVERIFY(hull.vertices.size() > 4 && hull.volume > 0);
        QVERIFY(hull.error <= 1e-3 * size);
    }
};

BARYCAGE_TEST(SlowExtentTest);
#include "slow_extent_test.moc"
