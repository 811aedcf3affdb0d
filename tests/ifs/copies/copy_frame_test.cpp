// SPDX-License-Identifier: MIT
#include "ifs/copies/copy_frame.h"
#include "ifs/copies/pictured_systems.h"
#include "support/named_test.h"

#include <QtTest>

using namespace ifs;
using namespace canonical;

class CopyFrameTest : public QObject {
    Q_OBJECT

private slots:
    void measuresTheTriangle() {
        const auto frame = CopyFrame::of(sierpinskiRight(), affineMap(200, 0, 0, -100, 7, 8));
        QVERIFY(frame);
        QCOMPARE(frame->hull.size(), 3u);
        QVERIFY(std::abs(frame->diameter - std::sqrt(2)) < 1e-12);
        QVERIFY((frame->centre - Vector<2>(1, 1) / 3).norm() < 1e-12);
        QVERIFY(std::abs(frame->pixel - 1. / 200) < 1e-15); // where it is smallest
        QVERIFY(std::abs(frame->thinness * frame->diameter / frame->pixel - CopyFrame::minThickness) < 1e-12);
        QVERIFY(!CopyFrame::of({affineMap(0, -1, 1, 0, 0, 0)}, {})); // no attractor
    }

    void hullHoldsTheAttractor() {
        for (const Maps2& maps : {maple(), fern(), koch(), levy(), eventual()}) {
            const auto frame = CopyFrame::of(maps, pictured(maps).display);
            QVERIFY(frame->hullError < 0.01 * frame->diameter);
            Random random(5);
            Vector<2> x = *fixedPoint(maps[1]);
            for (int n = 0; n < 20'000; ++n) {
                x = maps[random() % maps.size()](x);
                QVERIFY(distanceToConvex(frame->hull, x) <= frame->hullError);
            }
        }
    }

    // Nothing within the distance of the polygon is left outside, and little beyond is inside.
    void pushedOutHoldsTheNeighbourhood() {
        const Polygon sliver{{0, 0}, {4, 0}, {4, 0.01}};
        for (const Polygon& polygon : {Polygon{{0, 0}, {2, 0}, {1, 3}}, sliver, Polygon{{0, 0}, {3, 4}},
                                       Polygon{{5, 5}}, Polygon{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}) {
            constexpr double distance = 0.25;
            const Polygon wide = pushedOut(polygon, distance);
            QVERIFY(area(wide) > 0); // counter-clockwise
            for (const auto& corner : polygon)
                for (int i = 0; i < 360; ++i) {
                    const Vector<2> around =
                        corner + distance * (1 - 1e-9) * Vector<2>(std::cos(i * .0175), std::sin(i * .0175));
                    QVERIFY(distanceToConvex(wide, around) < 1e-12);
                }
            for (const auto& corner : wide)
                QVERIFY(distanceToConvex(polygon, corner) < 2.01 * distance);
        }
        QVERIFY(diameter({{0, 0}, {3, 4}, {1, 1}}) == 5);
        QVERIFY(diameter({{5, 5}}) == 0);
    }

    void shiftBoundsEveryPoint() {
        const Maps2 maps = maple();
        const auto frame = CopyFrame::of(maps, pictured(maps).display);
        Random random(9);
        for (int trial = 0; trial < 50; ++trial) {
            const AffineMap<2> a{randomMatrix<2>(random), randomVector<2>(random)};
            const AffineMap<2> b{randomMatrix<2>(random), randomVector<2>(random)};
            const double bound = maxShift(*frame, a, b);
            double furthest = 0;
            Vector<2> x = *fixedPoint(maps[1]);
            for (int n = 0; n < 5000; ++n) {
                x = maps[random() % maps.size()](x);
                furthest = std::max(furthest, (a(x) - b(x)).norm());
            }
            QVERIFY(furthest <= bound);
            QVERIFY(bound < 1.2 * furthest);
            QVERIFY(maxShift(*frame, a, a) == 0);
        }
    }
};

BARYCAGE_TEST(CopyFrameTest);
#include "copy_frame_test.moc"
