// SPDX-License-Identifier: MIT
#include "ifs/separation/exact_hull.h"

#include "ifs/canonical_systems.h"
#include "ifs/facts.h"
#include "support/named_test.h"

#include <QtTest>

using namespace ifs;

class TestExactHull : public QObject {
    Q_OBJECT

private slots:
    void polygonsAreExact_data() {
        QTest::addColumn<int>("corners");
        QTest::newRow("levy") << 8;
        QTest::newRow("heighway") << 10;
        QTest::newRow("twin") << 8;
        QTest::newRow("sierpinski") << 3;
        QTest::newRow("square") << 4;
    }
    void polygonsAreExact() {
        QFETCH(int, corners);
        const QByteArray name = QTest::currentDataTag();
        const auto maps = name == "levy"       ? canonical::levy()
                          : name == "heighway" ? canonical::heighway()
                          : name == "twin"     ? canonical::twin()
                          : name == "square"   ? canonical::square()
                                               : canonical::sierpinskiRight();
        const auto facts = factsOf(canonical::system<2>(maps));
        QCOMPARE(int(facts.hull->vertices.size()), corners);
        QVERIFY(facts.isHullExact);
        auto points = facts.extremePoints;
        QVERIFY(isExactHull(maps, points));
        std::reverse(points.begin(), points.end());
        QVERIFY(!isExactHull(maps, points));
    }

    // What lacks a corner is no hull: an image of another corner lies outside.
    void aMissingCornerShows() {
        const auto maps = canonical::levy();
        const auto facts = factsOf(canonical::system<2>(maps));
        for (std::size_t k = 0; k < facts.extremePoints.size(); ++k) {
            auto points = facts.extremePoints;
            points.erase(points.begin() + std::ptrdiff_t(k));
            QVERIFY(!isExactHull(maps, points));
            points.insert(points.begin() + std::ptrdiff_t(k), std::nullopt);
            QVERIFY(!isExactHull(maps, points));
        }
    }

    void segmentsAndPointsAreExact() {
        const std::vector<AffineMap<2>> segment{affineMap(.5, 0, 0, 0, 0, 0), affineMap(.5, 0, 0, 0, .5, 0)};
        const auto facts = factsOf(canonical::system<2>(segment));
        QCOMPARE(facts.hull->vertices.size(), std::size_t(2));
        QVERIFY(facts.isHullExact);
        auto ends = facts.extremePoints;
        ends.pop_back(); // the other end lies outside
        QVERIFY(!isExactHull(segment, ends));
        ends.push_back(ends.front());
        QVERIFY(!isExactHull(segment, ends));
        const std::vector<AffineMap<2>> point{affineMap(.5, 0, 0, .5, 1, 2)};
        QVERIFY(factsOf(canonical::system<2>(point)).isHullExact);
    }

    // A third has no double: its vertex is half a unit in the last place off at most.
    void verticesAreOnlyRounded() {
        const std::vector<AffineMap<2>> maps{affineMap(.25, 0, 0, .25, 0, 0),
                                             affineMap(.25, 0, 0, .25, .25, 0),
                                             affineMap(.25, 0, 0, .25, 0, .25)};
        const auto facts = factsOf(canonical::system<2>(maps));
        QVERIFY(facts.isHullExact);
        QVERIFY(facts.hull->error > 0 && facts.hull->error < 0x1p-52);
        auto moved = facts.extremePoints;
        moved.front()->point.x() += 1e-3;
        QVERIFY(roundingOf(maps, moved) >= 1e-3);
    }

    void roundOnesAreNot() {
        QVERIFY(!factsOf(canonical::system<2>(canonical::flower())).isHullExact);
        QVERIFY(!factsOf(canonical::system<2>(canonical::maple())).isHullExact);
    }

    // An image is known to rounding alone.
    void movedHullsAreNotExact() {
        const auto facts = factsOf(canonical::system<2>(canonical::levy()));
        QVERIFY(!moved(affineMap(1, .1, .2, 1, 0, 0), facts).isHullExact);
    }
};

BARYCAGE_TEST(TestExactHull);
#include "exact_hull_test.moc"
