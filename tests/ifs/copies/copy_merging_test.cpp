// SPDX-License-Identifier: MIT
#include "ifs/copies/copy_merging.h"
#include "ifs/copies/pictured_systems.h"
#include "support/named_test.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <map>

using namespace ifs;
using namespace canonical;

namespace {

// Of the collection: slow to shrink, so that it is nested more than eighty times in a large picture.
Maps2 featherSpiral() {
    return {
        affineMap(0.8588939923774256, 0.32969851358167623, -0.32969851358167623, 0.8588939923774256, 0, 0.1),
        affineMap(0.06, 0.3637306695894642, -0.10392304845413262, 0.21, 0.7, 0)};
}

// Every shape of the picture: which it is (−1 for the outline, else the projection), and its matrix to a
// billionth.
using Shape = std::array<long long, 7>;

Shape shapeOf(long long which, const AffineMap<2>& map) {
    const auto rounded = [](double number) { return std::llround(number * 1e9); };
    return {which,
            rounded(map.linear(0, 0)),
            rounded(map.linear(0, 1)),
            rounded(map.linear(1, 0)),
            rounded(map.linear(1, 1)),
            rounded(map.translation.x()),
            rounded(map.translation.y())};
}

void addShapes(std::vector<Shape>& shapes, const CopyHierarchy& hierarchy, int depth, const Copy& copy) {
    if (copy.projection) return shapes.push_back(shapeOf(static_cast<long long>(*copy.projection), copy.map));
    if (copy.level == 0) return shapes.push_back(shapeOf(-1, copy.map));
    for (const Copy& inner : hierarchy.copies(copy.level, depth))
        addShapes(shapes, hierarchy, depth, {copy.map * inner.map, inner.level, inner.projection, {}});
}

void addShapes(std::vector<Shape>& shapes, const MergedCopies& merged, const Copy& copy) {
    if (copy.projection) return shapes.push_back(shapeOf(static_cast<long long>(*copy.projection), copy.map));
    if (copy.level == 0) return shapes.push_back(shapeOf(-1, copy.map));
    const MergedCopies::Level& level = merged.levels().at(copy.level);
    for (const auto& [map, projection] : level.pieces)
        shapes.push_back(shapeOf(projection ? static_cast<long long>(*projection) : -1, copy.map * map));
    for (const Copy& inner : level.copies)
        addShapes(shapes, merged, {copy.map * inner.map, inner.level, inner.projection, {}});
}

// Two lists that were rounded from the same numbers.
bool areSame(std::vector<Shape> a, std::vector<Shape> b) {
    if (a.size() != b.size()) return false;
    const auto coarse = [](const Shape& shape) {
        Shape result = shape;
        for (std::size_t i = 1; i < result.size(); ++i)
            result[i] = (result[i] + 500) / 1000;
        return result;
    };
    const auto before = [&](const Shape& x, const Shape& y) { return coarse(x) < coarse(y); };
    std::ranges::sort(a, before);
    std::ranges::sort(b, before);
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        different += coarse(a[i]) != coarse(b[i]);
    return different <= a.size() / 1000; // on the edge of being rounded otherwise
}

} // namespace

class CopyMergingTest : public QObject {
    Q_OBJECT

private slots:
    void theShapesStayTheSame_data();
    void theShapesStayTheSame();
    void littleIsLeftAsItIs();
    void browsersAreSparedMost();
    void deepNestingWeighsMore();
    void whatIsWrittenIsBounded();
};

void CopyMergingTest::theShapesStayTheSame_data() {
    QTest::addColumn<int>("index");
    QTest::newRow("maple") << 0;
    QTest::newRow("fern") << 1;
    QTest::newRow("feather spiral") << 2;
    QTest::newRow("Sierpinski") << 3;
}

void CopyMergingTest::theShapesStayTheSame() {
    QFETCH(int, index);
    const Maps2 maps = index == 0   ? maple()
                       : index == 1 ? fern()
                       : index == 2 ? featherSpiral()
                                    : sierpinskiRight();
    const CopyHierarchy hierarchy = hierarchyOf(maps);
    const int depth = hierarchy.levelFor(1);
    const MergedCopies merged(hierarchy, depth);
    std::vector<Shape> expected, found;
    for (const Copy& copy : hierarchy.picture(depth))
        addShapes(expected, hierarchy, depth, copy);
    for (const Copy& copy : merged.picture())
        addShapes(found, merged, copy);
    QVERIFY(expected.size() > 100);
    QVERIFY(areSame(expected, found));
    std::set<std::size_t> projections;
    for (const Shape& shape : expected)
        if (shape[0] >= 0) projections.insert(static_cast<std::size_t>(shape[0]));
    QVERIFY(std::ranges::includes(projections, merged.projections()));
}

// One level of one map each, as drawing programs like to find them.
void CopyMergingTest::littleIsLeftAsItIs() {
    const CopyHierarchy hierarchy = hierarchyOf(maple());
    const MergedCopies merged(hierarchy, 5);
    for (const auto& [number, level] : merged.levels()) {
        QVERIFY(number == 0 ? level.pieces.size() == 1 : level.pieces.empty());
        if (number > 0) QCOMPARE(level.copies.size(), maple().size());
    }
}

void CopyMergingTest::browsersAreSparedMost() {
    const CopyHierarchy hierarchy =
        *CopyHierarchy::of(system<2>(featherSpiral()), pictured(featherSpiral(), 1200, 900).display);
    const int depth = hierarchy.levelFor(1);
    QVERIFY(hierarchy.references(depth) > 20'000);
    const MergedCopies merged(hierarchy, depth);
    QVERIFY2(merged.effort() <= MergedCopies::comfortable, qPrintable(QString::number(merged.effort())));
}

// A fern of ninety levels, whose largest map hardly shrinks.
void CopyMergingTest::deepNestingWeighsMore() {
    const Maps2 fishbone{affineMap(0, 0, 0, 0.25, 0, -0.4), affineMap(0.95, 0.002, -0.002, 0.93, -0.002, 0.5),
                         affineMap(0.035, -0.11, 0.27, 0.01, -0.05, 0.005),
                         affineMap(-0.04, 0.11, 0.27, 0.01, 0.047, 0.06)};
    const CopyHierarchy hierarchy =
        *CopyHierarchy::of(system<2>(fishbone), pictured(fishbone, 1200, 900).display);
    const int depth = hierarchy.levelFor(1);
    QVERIFY(depth > 60);
    const MergedCopies merged(hierarchy, depth);
    std::map<int, int> nested;
    for (const auto& [number, level] : merged.levels())
        for (const Copy& copy : level.copies)
            nested[number] = std::max(nested[number], 1 + (copy.projection ? 0 : nested[copy.level]));
    const auto isDeeper = [](const auto& a, const auto& b) { return a.second < b.second; };
    const int deepest = std::ranges::max_element(nested, isDeeper)->second;
    QVERIFY2(deepest < depth / 2, qPrintable(QString::number(deepest)));
}

void CopyMergingTest::whatIsWrittenIsBounded() {
    for (const Maps2& maps : {maple(), fern(), featherSpiral()}) {
        const CopyHierarchy hierarchy = hierarchyOf(maps);
        for (const int depth : {hierarchy.levelFor(1), hierarchy.deepest()}) {
            const MergedCopies merged(hierarchy, depth);
            std::size_t corners = 0, copies = 0;
            for (const auto& [number, level] : merged.levels()) {
                for (const auto& [map, projection] : level.pieces)
                    corners += projection ? 4 : hierarchy.outline(depth).size(); // a bar at least
                copies += level.copies.size();
            }
            QVERIFY(corners <= MergedCopies::maxCorners && copies <= MergedCopies::maxWritten);
        }
    }
}

BARYCAGE_TEST(CopyMergingTest);
#include "copy_merging_test.moc"
