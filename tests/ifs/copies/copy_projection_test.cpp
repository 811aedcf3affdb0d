// SPDX-License-Identifier: MIT
#include "ifs/copies/copy.h"
#include "ifs/copies/copy_projection.h"
#include "ifs/copies/pictured_systems.h"
#include "support/named_test.h"

#include <QtTest>

using namespace ifs;
using namespace canonical;

namespace {

// Seen along the first axis, the middle-third set.
Maps2 cantorTimesInterval() {
    return {affineMap(1. / 3, 0, 0, .5, 0, 0), affineMap(1. / 3, 0, 0, .5, 2. / 3, 0),
            affineMap(1. / 3, 0, 0, .5, 0, .5), affineMap(1. / 3, 0, 0, .5, 2. / 3, .5)};
}

} // namespace

class CopyProjectionTest : public QObject {
    Q_OBJECT

private slots:
    // Of the middle-third set, gaps wider than the detail stay: at 3⁻ᵏ⁻¹ < detail ≤ 3⁻ᵏ there are 2ᵏ
    // intervals.
    void middleThirds() {
        const Maps2 maps = cantorTimesInterval();
        for (const auto& [length, count] : {std::pair(0.004, 2u), {0.01, 4u}, {0.03, 8u}, {0.1, 16u}}) {
            CopyFrame frame = *CopyFrame::of(maps, affineMap(1000, 0, 0, 1000, 0, 0));
            frame.hullError = 0; // the square is exact
            const CopyProjection projection = projectionAlong(maps, frame, {1, 0}, length);
            QVERIFY(std::abs(projection.detail - 0.5e-3 / length) < 1e-12);
            QCOMPARE(projection.bars.size(), std::size_t(count));
            const double left = projection.bars.front()[0].x();
            const double right = projection.bars.back()[1].x();
            QVERIFY(std::abs(left + projection.detail / 2) < 1e-9);
            QVERIFY(std::abs(right - 1 - projection.detail / 2) < 1e-9);
            for (const Polygon& bar : projection.bars) // across: as far as the picture goes
                QVERIFY(std::abs((bar[3] - bar[0]).norm() - frame.diameter) < 1e-9);
        }
    }

    // Every point of the attractor is under a bar, and every bar has one.
    void barsCoverTheAttractor() {
        Random random(3);
        for (const Maps2& maps : {fern(), maple(), levy(), cantorTimesInterval()})
            for (int trial = 0; trial < 5; ++trial) {
                const double angle = uniform(random, 0, 3);
                const Vector<2> along(std::cos(angle), std::sin(angle));
                const CopyFrame frame = *CopyFrame::of(maps, pictured(maps).display);
                const CopyProjection projection = projectionAlong(maps, frame, along, 0.5);
                std::vector<bool> used(projection.bars.size());
                Vector<2> x = *fixedPoint(maps[1]);
                for (int n = 0; n < 30'000; ++n) {
                    x = maps[random() % maps.size()](x);
                    bool isInside = false;
                    for (std::size_t k = 0; k < used.size(); ++k) {
                        if (along.dot(x) < along.dot(projection.bars[k][0]) ||
                            along.dot(x) > along.dot(projection.bars[k][1]))
                            continue;
                        used[k] = isInside = true;
                    }
                    QVERIFY(isInside);
                }
                QVERIFY(std::ranges::all_of(used, std::identity()));
            }
    }

    void boundHoldsBothWays() {
        const Maps2 maps = fern();
        const CopyFrame frame = *CopyFrame::of(maps, pictured(maps).display);
        const AffineMap<2> flat = affineMap(.3, .1, .6, .2, 1, 2); // singular
        const CopyProjection projection = projectionBy(maps, frame, flat);
        const AffineMap<2> drawn = thickened(flat, frame.centre, frame.thinness);
        const double bound = maxShift(frame, projection, drawn, flat);
        QVERIFY(bound < 4 * frame.pixel);
        std::vector<Vector<2>> points;
        Random random(1);
        Vector<2> x = *fixedPoint(maps[1]);
        for (int n = 0; n < 20'000; ++n) // mostly up the stem, so that the tip is reached
            points.push_back(flat(x = maps[random() % 5 != 0 ? 1 : random() % maps.size()](x)));
        for (const Polygon& bar : projection.bars) {
            for (const auto& corner : bar) {
                const Vector<2> shown = drawn(corner);
                double nearest = HUGE_VAL;
                for (const auto& point : points)
                    nearest = std::min(nearest, (shown - point).norm());
                QVERIFY(nearest <= bound);
            }
        }
        for (const auto& point : points) {
            double nearest = HUGE_VAL;
            for (const Polygon& bar : projection.bars) {
                Polygon shown;
                for (const auto& corner : bar)
                    shown.push_back(drawn(corner));
                if (area(shown) < 0) std::ranges::reverse(shown);
                nearest = std::min(nearest, distanceToConvex(shown, point));
            }
            QVERIFY(nearest <= bound);
        }
    }

    void longestDirectionIsStretchedTheMost() {
        Random random(2);
        for (int trial = 0; trial < 1000; ++trial) {
            const Matrix<2> linear = randomMatrix<2>(random);
            const Vector<2> along = longestDirection(linear);
            QVERIFY(std::abs(along.norm() - 1) < 1e-14);
            QVERIFY(std::abs((linear * along).norm() - spectralNorm<2>(linear)) < 1e-12);
        }
    }
};

BARYCAGE_TEST(CopyProjectionTest);
#include "copy_projection_test.moc"
