// SPDX-License-Identifier: MIT
#include "collage/drawings.h"
#include "collage/measure/agreement.h"
#include "collage/random_collages.h"
#include "ifs/canonical_systems.h"
#include "support/named_test.h"
#include "support/near.h"

#include <QTest>

#include <Eigen/LU>

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
            const auto collage = random_collages::contracting(random);
            const double overlap = collageMeasure(picture(collage.mask), collage.maps).overlap;
            const double expected = overlapOf(picture(collage.mask), collage.maps);
            QVERIFY2(support::near(overlap, expected, 1e-12),
                     qPrintable(QStringLiteral("%1: %2, %3").arg(trial).arg(overlap).arg(expected)));
            anyOverlaps = anyOverlaps || overlap > 1.1;
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

    // Off the grid, too, a cell counts once, however many points of images lie in it.
    void excessIsThatOfTheAreas() {
        const Target whole = picture(triangle(512, 0.9));
        const auto far = ifs::affineMap(0.3, 0, 0, 0.3, 40, 0);
        for (const Maps& maps : {Maps{far}, Maps{far, far}}) {
            const Agreement images = collageMeasure(whole, maps).images;
            QVERIFY2(support::near(images.excess, 0.09, 0.005), qPrintable(QString::number(images.excess)));
            QCOMPARE(images.coverage, 0.0);
            QCOMPARE(images.iou, 0.0);
        }
        const Maps large{ifs::affineMap(2, 0, 0, 2, 40, 0)};
        QVERIFY(support::near(collageMeasure(whole, large).images.excess, 4, 0.05));
    }

    void mapsThatDoNotContractHaveNoBound() {
        const Mask mask = triangle(64, 0.8);
        QVERIFY(!collageMeasure(picture(mask), Maps{ifs::affineMap(1.2, 0, 0, 0.5, 0, 0)}).bound);
        QVERIFY(!collageMeasure(picture(mask), Maps{ifs::AffineMap<2>{}}).bound);
        const Maps far{ifs::affineMap(0.5, 0, 0, 0.5, 1e6, 0)};
        QVERIFY(support::near(collageMeasure(picture(mask), far).images.hausdorff, 64e6, 64e6 * 1e-3));
        const Maps near{ifs::affineMap(0.01, 0, 0, 0.01, 3, 0)}; // just off the grid
        QVERIFY(support::near(collageMeasure(picture(mask), near).images.hausdorff, 3.4 * 64, 3));
    }

    // The bound, and the converse: d_H(L, W(L)) ≤ (1 + s) d_H(L, A).
    void boundIsNeverViolated() {
        std::mt19937 random(11);
        double tightest = HUGE_VAL, tightestConverse = HUGE_VAL;
        for (int trial = 0; trial < 1000; ++trial) {
            const auto collage = random_collages::contracting(random);
            const Target l = picture(collage.mask);
            const CollageMeasure measure = collageMeasure(l, collage.maps);
            const double s = contraction(collage.maps);
            const auto truth = random_collages::distanceToAttractor(l, collage.maps, 1 / (1 - s));
            QVERIFY2(
                truth.least <= measure.bound.value(),
                qPrintable(QStringLiteral("%1: %2 > %3").arg(trial).arg(truth.least).arg(*measure.bound)));
            const double distance = measure.images.hausdorff;
            const double converse = (1 + s) * truth.most + (2 + s) * std::sqrt(0.5);
            QVERIFY2(distance <= converse,
                     qPrintable(QStringLiteral("%1: %2 > %3").arg(trial).arg(distance).arg(converse)));
            if (truth.least > 5) tightest = std::min(tightest, *measure.bound / truth.least);
            if (distance > 5) tightestConverse = std::min(tightestConverse, converse / distance);
        }
        // They say something.
        QVERIFY2(tightest < 1.5, qPrintable(QString::number(tightest)));
        QVERIFY2(tightestConverse < 2, qPrintable(QString::number(tightestConverse)));
    }

    // Where maps stretch, the bound is that of a norm in which they contract.
    void boundOfAnotherNormIsNeverViolated() {
        std::mt19937 random(12);
        double tightest = HUGE_VAL;
        for (int trial = 0; trial < 200; ++trial) {
            const auto collage = random_collages::stretching(random);
            const Target l = picture(collage.mask);
            const CollageMeasure measure = collageMeasure(l, collage.maps);
            QVERIFY(measure.contraction > 1);
            QVERIFY2(measure.bound && std::isfinite(*measure.bound), qPrintable(QString::number(trial)));
            QVERIFY(measure.norm.norm != ifs::NormKind::Euclidean);
            const double widening = measure.norm.equivalence / (1 - measure.norm.contractivity);
            const auto truth = random_collages::distanceToAttractor(l, collage.maps, widening);
            QVERIFY2(
                truth.least <= *measure.bound,
                qPrintable(QStringLiteral("%1: %2 > %3").arg(trial).arg(truth.least).arg(*measure.bound)));
            if (truth.least > 5) tightest = std::min(tightest, *measure.bound / truth.least);
        }
        QVERIFY2(tightest < 20, qPrintable(QString::number(tightest)));
    }

    // One map stretches by 2.118, and any five in a row contract: γ = 0.958 and C = 2.21 serve, or better
    // ones.
    void boundOfMapsThatContractLater() {
        const Maps maps{ifs::affineMap(0.5, 2, 0, 0.5, 0, 0), ifs::affineMap(0.5, 0, 0.1, 0.3, 0.2, 0)};
        const CollageMeasure measure = collageMeasure(picture(triangle(64, 0.8)), maps);
        QVERIFY(support::near(measure.contraction, 2.118033988750, 1e-9));
        const double pixels = measure.images.hausdorff + (2 + measure.contraction) / std::sqrt(2);
        QVERIFY(measure.bound.value() <= 2.212569920566 / (1 - 0.958037596608) * pixels * (1 + 1e-9));
        QVERIFY(support::near(*measure.bound,
                              measure.norm.equivalence / (1 - measure.norm.contractivity) * pixels, 1e-6));
        if (measure.norm.norm == ifs::NormKind::Ellipsoidal)
            for (const auto& map : maps)
                QVERIFY(ifs::spectralNorm<2>(measure.norm.root * map.linear * measure.norm.root.inverse()) <=
                        measure.norm.contractivity * (1 + 1e-12));
    }
};

BARYCAGE_TEST(AgreementTest);
#include "agreement_test.moc"
