// SPDX-License-Identifier: MIT
#include "collage/drawings.h"
#include "collage/fit/attractor_fit.h"
#include "collage/fit/collage_fit.h"
#include "collage/measure/agreement.h"
#include "collage/measure/attractor_points.h"
#include "collage/random_start.h"
#include "ifs/canonical_systems.h"
#include "support/named_test.h"
#include "support/near.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace collage;

namespace {

using Maps = std::vector<ifs::AffineMap<2>>;

const std::vector<double> mapleWeights{0.05, 0.3, 0.3, 0.35};

Maps maple() {
    return drawings::fitted(canonical::maple(), mapleWeights);
}

Target mapleTarget() {
    return target(drawings::chaosGame(maple(), mapleWeights, 256, 1'000'000), 2, 0.25);
}

Maps onGrid(const Grid& grid, const Maps& maps) {
    Maps result;
    for (const auto& map : maps)
        result.push_back(inGrid(grid, map));
    return result;
}

// The code of the maple, each of its maps a little off.
Maps disturbed() {
    Maps maps = maple();
    const auto turn = ifs::affineMap(0.98, -0.05, 0.05, 0.98, 0, 0);
    for (std::size_t i = 0; i < maps.size(); ++i)
        maps[i] = ifs::affineMap(1, 0, 0, 1, i % 2 == 0 ? 0.02 : -0.02, 0.015) * maps[i] * turn;
    return maps;
}

} // namespace

class CollageFitTest : public QObject {
    Q_OBJECT

private slots:
    void closestPointsImproveTheCollage() {
        const Target l = mapleTarget();
        CollageFit fit(l);
        Maps maps = onGrid(l.grid, disturbed());
        const double before = fit.error(maps);
        fit.improve(maps, {MapClass::Affine, 40, 0, 0.9, 0.9});
        QVERIFY2(fit.error(maps) < before / 3, qPrintable(QString::number(fit.error(maps) / before)));
        const std::vector<double> shares = fit.shares();
        QVERIFY(support::near(std::accumulate(shares.begin(), shares.end(), 0.0), 1, 1e-9));
    }

    void gaussNewtonImprovesTheAttractor() {
        const Target l = mapleTarget();
        const Maps before = disturbed();
        const Maps after = fittedAttractor(l, before, {});
        const double was = attractorAgreement(l, before).mean, is = attractorAgreement(l, after).mean;
        QVERIFY2(is < was / 3, qPrintable(QStringLiteral("%1 → %2").arg(was).arg(is)));
        QVERIFY(contraction(after) <= 0.95 + 1e-12);
    }

    void lockedMapsKeepTheirBits() {
        const Target l = mapleTarget();
        const std::vector<std::uint8_t> locked{0, 1, 1, 0};
        const Maps before = disturbed();
        const Maps after = fittedAttractor(l, before, {}, locked);
        Maps onIt = onGrid(l.grid, before);
        const Maps wasOnIt = onIt;
        CollageFit(l).improve(onIt, {}, locked);
        for (const std::size_t i : {1U, 2U}) {
            QCOMPARE(after[i], before[i]);
            QCOMPARE(onIt[i], wasOnIt[i]);
        }
        QVERIFY(!(onIt[0] == wasOnIt[0]) && !(onIt[3] == wasOnIt[3]));
        QVERIFY(!(after[0] == before[0] && after[3] == before[3]));
        QCOMPARE(fittedAttractor(l, before, {}, std::vector<std::uint8_t>(4, 1)), before);
    }

    // Not only between the levels of a refinement.
    void aStopEndsFitsBetweenIterations() {
        const Target l = mapleTarget();
        std::stop_source source;
        source.request_stop();
        Maps maps = onGrid(l.grid, disturbed());
        const Maps before = maps;
        CollageFit(l).improve(maps, {}, {}, source.get_token());
        QCOMPARE(maps, before);
        CollageFit(l).improve(maps, {});
        QVERIFY(maps != before);
        QCOMPARE(fittedAttractor(l, disturbed(), {}, {}, source.get_token()), disturbed());
        QVERIFY(fittedAttractor(l, disturbed(), {}) != disturbed());
    }

    // Against differences of the same points, found again with each number a little changed.
    void derivativesOfPoints() {
        const Maps maps{ifs::affineMap(0.6, -0.2, 0.3, 0.5, 4, 3),
                        ifs::affineMap(0.3, 0.4, -0.5, 0.2, 20, 30),
                        ifs::affineMap(-0.4, 0.1, 0.2, 0.55, 40, 5)};
        const Grid grid{0, 0, 1, 64, 64};
        const auto points = attractorPoints(maps, grid, 0.5, 500);
        QVERIFY(points.size() > 50);
        const PointDerivatives found = pointDerivatives(maps, points);
        constexpr double h = 1e-5;
        const auto placesWith = [&](Eigen::Index number, double by) {
            Maps changed = maps;
            ifs::AffineMap<2>& map = changed[std::size_t(number / 6)];
            const Eigen::Index k = number % 6;
            (k < 4 ? map.linear(k / 2, k % 2) : map.translation[k - 4]) += by;
            Eigen::VectorXd places(2 * Eigen::Index(points.size()));
            places.head<2>() = *ifs::fixedPoint(changed[0]);
            for (std::size_t p = 1; p < points.size(); ++p) {
                const ifs::Vector<2> from = places.segment<2>(2 * points[p].parent);
                places.segment<2>(2 * Eigen::Index(p)) = changed[std::size_t(points[p].map)](from);
            }
            return places;
        };
        QCOMPARE(found.rows(), 2 * Eigen::Index(points.size()));
        QCOMPARE(found.cols(), Eigen::Index{18});
        for (Eigen::Index number = 0; number < 18; ++number) {
            const Eigen::VectorXd difference = (placesWith(number, h) - placesWith(number, -h)) / (2 * h);
            QVERIFY((found.col(number) - difference).norm() <= 1e-5 * difference.norm());
            QVERIFY(difference.norm() > 1e-3);
        }
    }

    // Similarities of all angles, a third of them mirrored, each with its image somewhere on the target.
    void startsAreSpreadOut() {
        const Target l = mapleTarget();
        constexpr int count = 4, starts = 500;
        int mirrored = 0, byQuarter[4] = {};
        double least = 1, greatest = 0;
        for (std::uint64_t start = 0; start < starts; ++start)
            for (const auto& map : randomStart(l, count, {}, 7, start)) {
                const ifs::Vector<2> s = ifs::singularValues<2>(map.linear);
                QVERIFY(s[0] - s[1] < 1e-9);
                QVERIFY(s[0] >= 0.25 && s[0] <= 0.7);
                least = std::min(least, s[0]);
                greatest = std::max(greatest, s[0]);
                if (ifs::determinant<2>(map.linear) < 0) ++mirrored;
                const bool isRight = map.linear(0, 0) > 0, isUp = map.linear(1, 0) > 0;
                ++byQuarter[(isRight ? 1 : 0) + (isUp ? 2 : 0)];
                const ifs::Vector<2> place = map(l.mean);
                QVERIFY(l.mask(int(place.x()), int(place.y())));
            }
        QVERIFY(least < 0.26 && greatest > 0.69);
        constexpr double all = count * starts;
        QVERIFY(std::abs(mirrored / all - 1.0 / 3) < 0.05);
        for (const int quarter : byQuarter)
            QVERIFY(std::abs(quarter / all - 0.25) < 0.05);
    }

    // One map carries the target nearly into itself, and the others do not lie where that one does.
    void ledStartsHaveALeader() {
        const Target l = mapleTarget();
        Constraints stem;
        stem.first = FirstMap::Stem;
        for (std::uint64_t start = 0; start < 50; ++start) {
            const Maps maps = ledStart(l, 4, {}, 7, start);
            QCOMPARE(maps.size(), std::size_t{4});
            QCOMPARE(ledStart(l, 4, {}, 7, start), maps);
            QVERIFY(ledStart(l, 4, {}, 8, start) != maps);
            const double scale = ifs::spectralNorm<2>(maps[0].linear);
            QVERIFY(scale >= 0.7 - 1e-9 && scale <= 0.9 + 1e-9);
            double outside = 0; // the share of the leader's image that is far from the target
            for (std::size_t k = 0; k < l.cells.size(); ++k) {
                const ifs::Vector<2> place = maps[0]({l.columns[k], l.rows[k]});
                const int x = int(std::clamp(place.x(), 0.0, l.grid.width - 1.0));
                const int y = int(std::clamp(place.y(), 0.0, l.grid.height - 1.0));
                if (l.features.square[l.mask.index(x, y)] > 100) outside += 1.0 / double(l.cells.size());
            }
            QVERIFY2(outside < 0.05, qPrintable(QString::number(outside)));
            for (const std::size_t i : {1U, 2U, 3U})
                QVERIFY(ifs::spectralNorm<2>(maps[i].linear) <= 0.5 + 1e-9);
            const Maps withStem = ledStart(l, 4, stem, 7, start);
            QVERIFY(std::abs(ifs::determinant<2>(withStem[0].linear)) < 1e-9);
            QVERIFY(ifs::spectralNorm<2>(withStem[1].linear) >= 0.7 - 1e-9);
        }
    }

    void similaritiesStaySimilarities() {
        const Target l = target(drawings::all(256).front().mask, 4, 0.25);
        for (std::uint64_t start = 0; start < 20; ++start) {
            Maps maps = randomStart(l, 4, {}, 1, start);
            const Maps before = maps;
            CollageFit(l).improve(maps, {MapClass::Similarity, 20, 10, 0.75, 0.9});
            Maps plane;
            for (const auto& map : maps)
                plane.push_back(fromGrid(l.grid, map));
            plane = fittedAttractor(l, plane, {MapClass::Similarity, 4, 0.9});
            for (std::size_t i = 0; i < maps.size(); ++i) {
                const ifs::Vector<2> s = ifs::singularValues<2>(plane[i].linear);
                QVERIFY(s[0] - s[1] < 1e-9 && s[0] <= 0.9 + 1e-12);
                QVERIFY(ifs::determinant<2>(plane[i].linear) * ifs::determinant<2>(before[i].linear) > 0);
            }
        }
    }

    void normsAreLimited() {
        const auto map = ifs::affineMap(1.2, 0.3, -0.2, 0.4, 2, 3);
        const ifs::Vector<2> centre(5, -1);
        const auto limited = withNormAtMost(0.75, map, centre);
        QVERIFY(support::near(ifs::spectralNorm<2>(limited.linear), 0.75, 1e-12));
        QVERIFY(support::near<2>(limited(centre), map(centre), 1e-12));
        QCOMPARE(withNormAtMost(1.3, map, centre), map);
    }

    void leastSquaresFindTheMap() {
        for (const double sigma : {1.0, -1.0}) {
            const auto map = ifs::affineMap(0.4, -sigma * 0.3, 0.3, sigma * 0.4, 7, -2);
            PairSums sums;
            for (const auto& [x, y] : {std::pair{0.0, 0.0}, {3.0, 1.0}, {-2.0, 5.0}, {4.0, -4.0}}) {
                const ifs::Vector<2> image = map({x, y});
                sums.add(x, y, image.x(), image.y(), 1 + x * x);
            }
            for (const MapClass mapClass : {MapClass::Affine, MapClass::Similarity}) {
                const auto found = leastSquaresMap(sums, mapClass, ifs::affineMap(1, 0, 0, sigma, 0, 0));
                QVERIFY((found.linear - map.linear).norm() < 1e-9);
                QVERIFY(support::near<2>(found.translation, map.translation, 1e-9));
            }
        }
    }
};

BARYCAGE_TEST(CollageFitTest);
#include "collage_fit_test.moc"
