// SPDX-License-Identifier: MIT
#include "collage/drawings.h"
#include "collage/measure/agreement.h"
#include "collage/measure/attractor_points.h"
#include "ifs/canonical_systems.h"
#include "support/near.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

using namespace collage;

namespace {

using Maps = std::vector<ifs::AffineMap<2>>;

Target picture(const Mask& mask) {
    return target(mask, 1, 0.5);
}

// An equilateral triangle with one side at the bottom, its centroid at the origin; the side is `side` units.
Mask triangle(int pixels, double side) {
    return drawings::drawn(pixels, [side](double x, double y) {
        const double inradius = side * std::sqrt(3) / 6 * 2; // −1 … 1 is one unit
        return y >= -inradius && std::abs(x) * std::sqrt(3) + y <= 2 * inradius;
    });
}

Maps sierpinski(double side) {
    Maps maps;
    for (const double angle : {90.0, 210.0, 330.0}) {
        const double radius = side / std::sqrt(3);
        const double radians = angle * std::acos(-1.0) / 180;
        maps.push_back(
            ifs::affineMap(0.5, 0, 0, 0.5, radius / 2 * std::cos(radians), radius / 2 * std::sin(radians)));
    }
    return maps;
}

struct Collage {
    Mask mask;
    Maps maps;
};

Collage randomCollage(std::mt19937& random) {
    const auto between = [&](double a, double b) { return a + (b - a) * random() * 0x1p-32; };
    Collage collage{emptyMask(24, 24), {}};
    for (int disc = 0; disc < 3; ++disc) {
        const double x = between(4, 20), y = between(4, 20), r = between(0.8, 5);
        for (int v = 0; v < 24; ++v)
            for (int u = 0; u < 24; ++u)
                if (std::hypot(u - x, v - y) < r) collage.mask.cells[collage.mask.index(u, v)] = 1;
    }
    for (int i = 0; i < 2 + int(random() % 3); ++i) {
        ifs::AffineMap<2> map = ifs::affineMap(between(-1, 1), between(-1, 1), between(-1, 1), between(-1, 1),
                                               between(-0.3, 0.3), between(-0.3, 0.3));
        map.linear *= between(0.1, 0.85) / ifs::spectralNorm<2>(map.linear);
        collage.maps.push_back(map);
    }
    return collage;
}

// A number of pixels below d_H(L, A), close to it: points of the squares of L against points of A that are at
// most `gap` from all of A.
double lowerBound(const Target& target, const Maps& maps) {
    Maps inside;
    for (const auto& map : maps)
        inside.push_back(inGrid(target.grid, map));
    constexpr double step = 0.5;
    const auto points = attractorPoints(inside, target.grid, step, 300'000);
    const double gap = step * std::sqrt(2) / (1 - contraction(maps));
    double distance = 0;
    for (std::size_t k = 0; k < target.cells.size(); k += 1 + target.cells.size() / 30) {
        double least = HUGE_VAL;
        for (const AttractorPoint& point : points)
            least = std::min(least, std::hypot(point.x - target.columns[k], point.y - target.rows[k]));
        distance = std::max(distance, least - gap);
    }
    for (std::size_t p = 0; p < points.size(); p += 1 + points.size() / 300) {
        double least = HUGE_VAL;
        for (std::size_t k = 0; k < target.cells.size(); ++k)
            least = std::min(least, std::hypot(std::max(0.0, std::abs(points[p].x - target.columns[k]) - 0.5),
                                               std::max(0.0, std::abs(points[p].y - target.rows[k]) - 0.5)));
        distance = std::max(distance, least);
    }
    return distance;
}

// Cells of images of cells, one set for each map and one for all.
double overlapOf(const Target& target, const Maps& maps) {
    using Cells = std::set<std::pair<double, double>>;
    Cells all;
    std::size_t sum = 0;
    for (const auto& map : maps) {
        Cells own;
        const auto inside = inGrid(target.grid, map);
        std::vector<ifs::Vector<2>> offsets{{0, 0}};
        if (ifs::spectralNorm<2>(map.linear) > 0.7)
            offsets.insert(offsets.end(), {{-0.25, -0.25}, {-0.25, 0.25}, {0.25, -0.25}, {0.25, 0.25}});
        for (int y = 0; y < target.grid.height; ++y)
            for (int x = 0; x < target.grid.width; ++x)
                for (const auto& offset : offsets) {
                    if (!target.mask(x, y)) continue;
                    const ifs::Vector<2> image = inside(ifs::Vector<2>(x + 0.5, y + 0.5) + offset);
                    own.emplace(std::floor(image.x()), std::floor(image.y()));
                }
        sum += own.size();
        all.insert(own.begin(), own.end());
    }
    return double(sum) / double(all.size());
}

} // namespace

class AgreementTest : public QObject {
    Q_OBJECT

private slots:
    // L = [0, 1] and the maps of the Cantor set: d_H(L, W(L)) = 1/6, the bound 1/4, and d_H(L, A) = 1/6.
    void cantorSet() {
        Mask mask = emptyMask(735, 3);
        for (int x = 3; x < 732; ++x)
            mask.cells[mask.index(x, 1)] = 1;
        const double length = 729.0 / 3;
        const Maps maps{ifs::affineMap(1.0 / 3, 0, 0, 1.0 / 3, -length / 3, 0),
                        ifs::affineMap(1.0 / 3, 0, 0, 1.0 / 3, length / 3, 0)};
        const CollageMeasure measure = collageMeasure(picture(mask), maps);
        QVERIFY(support::near(measure.images.hausdorff, 729.0 / 6, 1));
        QVERIFY(support::near(measure.contraction, 1.0 / 3, 1e-12));
        const double pixels = (2 + 1.0 / 3) / std::sqrt(2) * 1.5;
        QVERIFY(support::near(measure.bound.value(), 729.0 / 4 + pixels, 2));
        QVERIFY(support::near(attractorAgreement(picture(mask), maps).hausdorff, 729.0 / 6, 1));
        QVERIFY(support::near(measure.images.coverage, 2.0 / 3, 0.01));
        QVERIFY(support::near(measure.images.worst.x(), 0, 0.5));
    }

    // The triangle under the maps of Sierpiński: IoU 3/4, and the inradius of what is removed.
    void sierpinskiTriangle() {
        constexpr int pixels = 512;
        const double side = 0.9;
        const CollageMeasure measure = collageMeasure(picture(triangle(pixels, side)), sierpinski(side));
        QVERIFY(support::near(measure.images.iou, 0.75, 0.01));
        QVERIFY(support::near(measure.images.coverage, 0.75, 0.01));
        QVERIFY(measure.images.excess < 0.01);
        QVERIFY(support::near(measure.images.hausdorff, 0.144337567297 * side * pixels, 1.5));
        QVERIFY(
            support::near(measure.bound.value(), 2 * (measure.images.hausdorff + 2.5 / std::sqrt(2)), 1e-9));
        // The incentre of the removed triangle is that of the whole one.
        QVERIFY(support::near<2>(measure.images.worst, ifs::Vector<2>(0, 0), 0.01));
    }

    // L = A: nothing is wrong. The picture comes from the chaos game, not from the points measured.
    void attractorAgreesWithItself() {
        const Maps maps = drawings::fitted(canonical::maple(), std::vector<double>{0.05, 0.3, 0.3, 0.35});
        const Mask mask =
            drawings::chaosGame(maps, std::vector<double>{0.05, 0.3, 0.3, 0.35}, 256, 3'000'000);
        const Agreement attractor = attractorAgreement(picture(mask), maps);
        QVERIFY(attractor.iou > 0.95);
        QVERIFY(attractor.mean < 0.05);
        QVERIFY(attractor.hausdorff <= 1.5);
        const CollageMeasure measure = collageMeasure(picture(mask), maps);
        QVERIFY(measure.images.iou > 0.9);
        QVERIFY(measure.images.hausdorff <= 2);
        const Mask points = attractorMask(picture(mask).grid, maps);
        QVERIFY(std::abs(double(area(points)) / double(area(mask)) - 1) < 0.05);
    }

    // Σ |w_i(L)| / |W(L)|, by sets of cells.
    void overlapAgreesWithSetsOfCells() {
        std::mt19937 random(5);
        bool anyOverlaps = false;
        for (int trial = 0; trial < 100; ++trial) {
            const Collage collage = randomCollage(random);
            const double overlap = collageMeasure(picture(collage.mask), collage.maps).overlap;
            const double expected = overlapOf(picture(collage.mask), collage.maps);
            QVERIFY2(support::near(overlap, expected, 1e-12),
                     qPrintable(QStringLiteral("%1: %2, %3").arg(trial).arg(overlap).arg(expected)));
            anyOverlaps = anyOverlaps || overlap > 1.5;
        }
        QVERIFY(anyOverlaps);
    }

    void overlapIsThatOfTheAreas() {
        const Target whole = picture(triangle(512, 0.9));
        const Maps maps = sierpinski(0.9);
        QVERIFY(support::near(collageMeasure(whole, maps).overlap, 1, 0.01));
        const auto overlap = [&](const Maps& of) { return collageMeasure(whole, of).overlap; };
        QCOMPARE(overlap({maps[0]}), 1.0);
        QCOMPARE(overlap({maps[0], maps[0], maps[0]}), 3.0);
        const auto far = ifs::affineMap(0.3, 0, 0, 0.3, 40, 0), large = ifs::affineMap(0.9, 0, 0, 0.9, 40, 0);
        QCOMPARE(overlap({far, far}), 2.0); // off the grid
        QCOMPARE(overlap({far, maps[0]}), 1.0);
        QVERIFY(support::near(overlap({far, large}), (0.09 + 0.81) / 0.81, 0.01));
        // Two copies of a square that have half of each in common.
        Mask square = emptyMask(64, 64);
        std::ranges::fill(square.cells, std::uint8_t(1));
        const Maps shifted{ifs::affineMap(0.5, 0, 0, 0.5, -0.125, 0),
                           ifs::affineMap(0.5, 0, 0, 0.5, 0.125, 0)};
        QCOMPARE(collageMeasure(picture(square), shifted).overlap, 4.0 / 3);
    }

    void mapsThatStretchHaveNoBound() {
        const Mask mask = triangle(64, 0.8);
        QVERIFY(!collageMeasure(picture(mask), Maps{ifs::affineMap(1.2, 0, 0, 0.5, 0, 0)}).bound);
        QVERIFY(!collageMeasure(picture(mask), Maps{ifs::AffineMap<2>{}}).bound);
        const Maps far{ifs::affineMap(0.5, 0, 0, 0.5, 1e6, 0)};
        QVERIFY(support::near(collageMeasure(picture(mask), far).images.hausdorff, 64e6, 64e6 * 1e-3));
        const Maps near{ifs::affineMap(0.01, 0, 0, 0.01, 3, 0)}; // just off the grid
        QVERIFY(support::near(collageMeasure(picture(mask), near).images.hausdorff, 3.4 * 64, 3));
    }

    void boundIsNeverViolated() {
        std::mt19937 random(11);
        double tightest = HUGE_VAL;
        for (int trial = 0; trial < 1000; ++trial) {
            const Collage collage = randomCollage(random);
            if (area(collage.mask) == 0) continue;
            const Target l = picture(collage.mask);
            const CollageMeasure measure = collageMeasure(l, collage.maps);
            const double truth = lowerBound(l, collage.maps);
            QVERIFY2(truth <= measure.bound.value(),
                     qPrintable(QStringLiteral("%1: %2 > %3").arg(trial).arg(truth).arg(*measure.bound)));
            if (truth > 5) tightest = std::min(tightest, *measure.bound / truth);
        }
        QVERIFY2(tightest < 1.5, qPrintable(QString::number(tightest))); // it says something
    }
};

QTEST_APPLESS_MAIN(AgreementTest)
#include "agreement_test.moc"
