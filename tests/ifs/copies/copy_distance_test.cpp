// SPDX-License-Identifier: MIT
#include "ifs/copies/copy_distance.h"
#include "ifs/copies/pictured_systems.h"
#include "support/named_test.h"

#include <QtTest>

using namespace ifs;
using namespace canonical;

namespace {

const AffineMap<2> display = affineMap(200, 0, 0, -200, 30, 500);
const Polygon triangle{{0, 0}, {1, 0}, {0, 1}};
constexpr double slack = 3 * CopyDistance::finest;

Polygon seen(const AffineMap<2>& map) {
    Polygon image;
    for (const auto& corner : triangle)
        image.push_back((display * map)(corner));
    return image;
}

} // namespace

class CopyDistanceTest : public QObject {
    Q_OBJECT

private slots:
    // The points that are furthest away are in the middle of the hole, which is half as large as the copy: as
    // far as the radius of its incircle.
    void holesOfTheTriangleAreMeasured() {
        const CopyDistance distance(sierpinskiRight(), {display}, triangle);
        const double radius = 200 * 0.25 * (2 - std::sqrt(2));
        QVERIFY(distance.farthest(seen({})) >= radius);
        QVERIFY(distance.farthest(seen({})) < radius + slack);
        for (const auto& map : sierpinskiRight()) {
            QVERIFY(distance.farthest(seen(map)) >= radius / 2);
            QVERIFY(distance.farthest(seen(map)) < radius / 2 + slack);
        }
    }

    // Little more than by a chaos game, and no more of a part than of the whole.
    void boundsHold() {
        Random random(7);
        for (const Maps2& maps : {maple(), fern(), koch(), levy()}) {
            const Pictured picture = pictured(maps);
            const auto frame = CopyFrame::of(maps, picture.display);
            const CopyDistance distance(maps, {picture.display}, frame->hull);
            std::vector<Vector<2>> points;
            Vector<2> x = *fixedPoint(maps[1]);
            for (int n = 0; n < 20'000; ++n)
                points.push_back(picture.display(x = maps[random() % maps.size()](x)));
            for (int trial = 0; trial < 30; ++trial) {
                const Vector<2> share(uniform(random, 0, 1), uniform(random, 0, 1));
                const Vector<2> p =
                    picture.display(picture.box.min + share.cwiseProduct(picture.box.max - picture.box.min));
                const Polygon small{p, p + Vector<2>(1, 0), p + Vector<2>(0, 1)};
                double nearest = HUGE_VAL; // or nearer: some parts of the attractor are seldom met
                for (const auto& point : points)
                    nearest = std::min(nearest, (point - p).norm());
                const double found = distance.farthest(small);
                QVERIFY2(found < nearest + 1 + 2 * slack, qPrintable(QString::number(found - nearest)));
                QVERIFY(found < distance.farthest({p, p + Vector<2>(30, 0), p + Vector<2>(0, 30)}) + 1e-9);
            }
        }
    }

    void partsAreWhereTheyAreShown() {
        const AffineMap<2> aside = affineMap(1, 0, 0, 1, 3, 0);
        const CopyDistance distance(sierpinskiRight(), {display, display * aside}, triangle);
        QVERIFY(distance.farthest(seen(aside)) < 200 * 0.25 * (2 - std::sqrt(2)) + slack);
        const Polygon between = seen(affineMap(0.01, 0, 0, 0.01, 2, 0)); // one unit from each
        QVERIFY(std::abs(distance.farthest(between) - 200) < 2 + slack);
    }

    // Of shapes as large as nothing that is drawn there is no bound.
    void hugeShapesHaveNoBound() {
        const CopyDistance distance(sierpinskiRight(), {display}, triangle);
        QVERIFY(std::isinf(distance.farthest({{0, 0}, {1e9, 0}, {0, 1}})));
    }
};

BARYCAGE_TEST(CopyDistanceTest);
#include "copy_distance_test.moc"
