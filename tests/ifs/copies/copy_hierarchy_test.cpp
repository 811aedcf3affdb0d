// SPDX-License-Identifier: MIT
#include "ifs/copies/copy_hierarchy.h"
#include "ifs/copies/pictured_systems.h"
#include "support/named_test.h"
#include "support/processor_timer.h"

#include <QtTest>

using namespace ifs;
using namespace canonical;

class CopyHierarchyTest : public QObject {
    Q_OBJECT

private slots:
    void copiesComposeLikeTheMaps_data() { systems(); }
    void copiesComposeLikeTheMaps();
    void onlyActiveMapsMakeCopies();
    void referencesAreCountedAndBounded_data() { systems(); }
    void referencesAreCountedAndBounded();
    void outlineHoldsTheAttractor_data() { systems(); }
    void outlineHoldsTheAttractor();
    void outlineOfASlantedSegmentHasArea();
    void singularMapsStayVisibleAtEveryDepth();
    void projectionsKeepTheirGaps();
    void singularMapsCostNothingBelowThem();
    void movedBranchesAreCopiedWhereTheyAre();
    void thinPicturesAreWrittenOut();
    void noAttractorNoCopies();

private:
    static void systems() {
        QTest::addColumn<int>("index");
        for (int i = 0; i < 4; ++i)
            QTest::addRow("%s", names[i]) << i;
    }
    static Maps2 mapsOf(int index) {
        return index == 0 ? maple() : index == 1 ? flower() : index == 2 ? fern() : sierpinskiRight();
    }
    static constexpr const char* names[] = {"maple", "flower", "fern", "sierpinski"};
};

// Down to level 0, by every map that is not singular, exactly; levels fall by what the maps shrink.
void CopyHierarchyTest::copiesComposeLikeTheMaps() {
    QFETCH(int, index);
    const Maps2 maps = mapsOf(index);
    const CopyHierarchy levels = hierarchyOf(maps);
    constexpr int depth = 6;
    const std::vector<Copy> picture = levels.picture(depth);
    QCOMPARE(picture.size(), maps.size());
    for (std::size_t i = 0; i < maps.size(); ++i) {
        QCOMPARE(picture[i].first, std::optional(i));
        QVERIFY(picture[i].level < depth);
        if (!levels.projection(i)) QVERIFY(picture[i].map == maps[i]);
        QCOMPARE(picture[i].projection.has_value(), levels.projection(i).has_value());
        QVERIFY(std::isnormal(determinant<2>(levels.copy(i, 1, depth).map.linear)));
    }
    const auto largest =
        std::ranges::max(maps, {}, [](const auto& map) { return determinant<2>(map.linear); });
    QVERIFY(std::ranges::any_of(levels.copies(depth, depth), [&](const Copy& copy) {
        return copy.level == depth - 1 && copy.map == largest;
    }));
}

void CopyHierarchyTest::onlyActiveMapsMakeCopies() {
    auto code = canonical::system<2>(sierpinskiRight());
    append(code, affineMap(.9, 0, 0, .9, 9, 9));
    code.maps[3].enabled = code.maps[1].enabled = false;
    const auto levels = CopyHierarchy::of(code, affineMap(200, 0, 0, -200, 0, 200));
    QCOMPARE(levels->index(), (std::vector<std::size_t>{0, 2}));
    QCOMPARE(levels->copies(3, 3).size(), 2u);
    QVERIFY(levels->copy(1, 3, 3).map == code.maps[2].map);
}

void CopyHierarchyTest::referencesAreCountedAndBounded() {
    QFETCH(int, index);
    const CopyHierarchy levels = hierarchyOf(mapsOf(index));
    constexpr int depth = 5;
    const std::function<std::uint64_t(const std::vector<Copy>&)> count = [&](const auto& copies) {
        std::uint64_t sum = 0;
        for (const Copy& copy : copies) {
            const bool isLeaf = copy.projection || copy.level == 0;
            sum += 1 + (isLeaf ? 0 : count(levels.copies(copy.level, depth)));
        }
        return sum;
    };
    QCOMPARE(levels.references(depth), count(levels.picture(depth)));
    QVERIFY(levels.references(levels.deepest()) < CopyHierarchy::maxReferences);
    QCOMPARE(levels.references(levels.deepest() + 1), CopyHierarchy::maxReferences);
}

void CopyHierarchyTest::outlineHoldsTheAttractor() {
    QFETCH(int, index);
    const Maps2 maps = mapsOf(index);
    const CopyHierarchy levels = hierarchyOf(maps);
    const Pictured seen = pictured(maps);
    const Polygon outline = levels.outline(0);
    std::mt19937 random(5);
    Vector<2> x = *fixedPoint(maps[1]);
    for (int n = 0; n < 20'000; ++n) {
        x = maps[random() % maps.size()](x);
        for (std::size_t i = 0; i < outline.size(); ++i)
            QVERIFY(cross(outline[(i + 1) % outline.size()] - outline[i], x - outline[i]) >= 0);
    }
    // And not far beyond: within a few pixels of the certified box.
    for (const auto& vertex : outline)
        QVERIFY((vertex - vertex.cwiseMax(seen.box.min).cwiseMin(seen.box.max)).norm() * seen.pixelsPerUnit <
                3);
    // Wider the smaller the copies, so that they do not fade, but never out of all proportion.
    const auto left = [](const Polygon& polygon) {
        return std::ranges::min(polygon, {}, [](const auto& vertex) { return vertex.x(); }).x();
    };
    const double size = (seen.box.max - seen.box.min).norm();
    const double wider = (left(outline) - left(levels.outline(CopyHierarchy::maxLevels))) / size;
    QVERIFY2(wider > 0.4 && wider < 1, qPrintable(QString::number(wider)));
}

void CopyHierarchyTest::outlineOfASlantedSegmentHasArea() {
    const CopyHierarchy levels =
        hierarchyOf({affineMap(.5, 0, 0, .5, 0, 0), affineMap(.5, 0, 0, .5, .5, .5)});
    QVERIFY(area(levels.outline(0)) > 5e-7);
}

// The stem of a stem-like system: no copy of it, however deep, is so thin that it fades away, nor moved by
// more than the stated error; a map that is not singular stays as it is.
void CopyHierarchyTest::singularMapsStayVisibleAtEveryDepth() {
    const Maps2 maps = fern();
    const AffineMap<2> display = pictured(maps).display;
    const CopyHierarchy levels = hierarchyOf(maps);
    const int depth = levels.levelFor(1);
    const double error = levels.error(depth);
    QVERIFY(levels.projection(0) && !levels.projection(1));
    const auto& bars = levels.projection(0)->bars;
    QCOMPARE(bars.size(), 1u); // the fern seen from below has no gap
    Vector<2> x = *fixedPoint(maps[1]);
    std::mt19937 random(5);
    int stems = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        AffineMap<2> drawn = display;
        AffineMap<2> exact = display;
        for (int level = depth; level > 0;) {
            const bool whole = level == depth;
            const std::size_t i = random() % maps.size();
            const Copy copy = levels.copy(i, level, depth);
            drawn = drawn * copy.map;
            exact = exact * maps[i];
            QVERIFY(i == 0 || copy.map == maps[i]);
            level = copy.level;
            if (i != 0) continue;
            ++stems;
            const Vector<2> side = drawn(bars[0][0]) - drawn(bars[0][3]);
            const Vector<2> along = drawn(bars[0][1]) - drawn(bars[0][0]);
            const double thickness = std::abs(cross(side, along)) / along.norm();
            // Of the whole picture it is seen well, of its smallest copies still.
            QVERIFY2(thickness > (whole ? 0.9 : 0.3) && thickness < 2,
                     qPrintable(QString::number(thickness)));
            break;
        }
        QVERIFY((drawn(x) - exact(x)).norm() <= error);
        x = maps[1 + random() % (maps.size() - 1)](x);
    }
    QVERIFY(stems > 1000);
}

// What a singular map shows may have gaps: they stay.
void CopyHierarchyTest::projectionsKeepTheirGaps() {
    const auto at = [](double scale, double x, double y) { return affineMap(scale, 0, 0, scale, x, y); };
    const Maps2 maps{at(.2, 0, 0), at(.2, .8, .2), affineMap(.1, 0, 0, 0, .45, 1)};
    const CopyHierarchy levels = hierarchyOf(maps);
    QVERIFY(levels.projection(2));
    const auto& bars = levels.projection(2)->bars;
    QVERIFY2(bars.size() > 2, qPrintable(QString::number(bars.size())));
    for (const auto& bar : bars)
        QVERIFY((bar[3] - bar[0] - (bar[2] - bar[1])).norm() < 1e-12 && (bar[3] - bar[0]).norm() > .1);
}

// Their bars are all that is drawn at every depth: two copies, whose error stays.
void CopyHierarchyTest::singularMapsCostNothingBelowThem() {
    const CopyHierarchy levels =
        hierarchyOf({affineMap(-.169, .104, 0, 0, 1.35, -.963), affineMap(-.401, .217, 0, 0, 1.44, -1.07)});
    const support::ProcessorTimer clock;
    QCOMPARE(levels.references(150), 2u);
    const double error = levels.error(150);
    QVERIFY2(error > 0.5 && error < 3, qPrintable(QString::number(error)));
    QVERIFY(std::abs(levels.error(1) - error) < 0.1);
    QVERIFY2(clock.elapsed() < 5000, qPrintable(QString::number(clock.elapsed())));
    // A depth that nothing can be drawn at has no bound, and is told so at once.
    const CopyHierarchy many = hierarchyOf(sierpinskiRight());
    QVERIFY(std::isinf(many.error(CopyHierarchy::maxLevels)));
    QVERIFY(std::isfinite(many.error(many.deepest())));
}

void CopyHierarchyTest::movedBranchesAreCopiedWhereTheyAre() {
    const Maps2 maps = sierpinskiRight();
    const AffineMap<2> aside = affineMap(1, 0, 0, 1, 5, 0);
    const MovedBranch<2> moved{{1, 2}, aside};
    const auto levels =
        CopyHierarchy::of(canonical::system<2>(maps), pictured(maps).display, std::span(&moved, 1));
    // Pieces 1, 2 1, 2 2, 2 3 and 3, counted from 1.
    const auto picture = levels->picture(6);
    QCOMPARE(picture.size(), 5u);
    QVERIFY(std::ranges::any_of(picture, [&](const Copy& copy) {
        return copy.map == aside * (maps[1] * maps[2]) && copy.level == 4 && copy.first == 1u;
    }));
    QCOMPARE(levels->references(2), 2u * (1 + 3) + 3u);
}

// Copies that would fade away however large they are kept: dots and bars, no deeper than need be.
void CopyHierarchyTest::thinPicturesAreWrittenOut() {
    const CopyHierarchy levels =
        hierarchyOf({affineMap(-.29162, .202607, -.407927, .241756, 1.195094, .507223),
                     affineMap(.287476, -.190696, 0, 0, .402597, 1.694427)});
    const auto picture = levels.picture(CopyHierarchy::maxLevels);
    QCOMPARE(levels.deepest(), CopyHierarchy::maxLevels);
    QCOMPARE(levels.references(CopyHierarchy::maxLevels), std::uint64_t(picture.size()));
    for (const Copy& copy : picture) {
        QCOMPARE(copy.level, 0);
        if (copy.projection) QVERIFY(levels.projection(*copy.projection));
    }
    const double error = levels.error(levels.levelFor(1));
    QVERIFY2(error < 4, qPrintable(QString::number(error)));
}

void CopyHierarchyTest::noAttractorNoCopies() {
    QVERIFY(!CopyHierarchy::of(canonical::system<2>({affineMap(0, -1, 1, 0, 0, 0)}), {}));
    QVERIFY(!CopyHierarchy::of({}, {}));
}

BARYCAGE_TEST(CopyHierarchyTest);
#include "copy_hierarchy_test.moc"
