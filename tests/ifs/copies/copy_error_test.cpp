// SPDX-License-Identifier: MIT
#include "ifs/copies/copy_error.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>

using namespace ifs;

namespace {

// Of the Sierpiński triangle, in pixels: whole, and three half as large copies a level.
CopyExpansion copiesOfTriangle(int depth) {
    CopyExpansion expansion;
    expansion.diameter = 2;
    expansion.area = 3;
    const CopyStep half{0.5 * Matrix<2>::Identity(), 0, false, 0.25};
    expansion.picture = {{100 * Matrix<2>::Identity(), depth, false, 1}};
    expansion.copies.resize(1);
    for (int level = 1; level <= depth; ++level) {
        expansion.copies.emplace_back(3, half);
        for (CopyStep& step : expansion.copies.back())
            step.level = level - 1;
    }
    return expansion;
}

} // namespace

class CopyErrorTest : public QObject {
    Q_OBJECT

private slots:
    // By hand: sizes are 200·2⁻ᵏ, areas 3·(3/4)ᵏ·10⁴, and shifts 1 + 25·(1 + 1/2 + … ) by k steps.
    void sumsOverTheTriangle() {
        for (int depth = 0; depth < 6; ++depth) {
            const CopyDeviation found = deviation(copiesOfTriangle(depth), 10'000);
            const double size = 200 * std::pow(.5, depth);
            QCOMPARE(found.largest, size);
            QCOMPARE(found.area, 3e4 * std::pow(.75, depth));
            QCOMPARE(found.length, size * std::pow(3., depth));
            QCOMPARE(found.error, size + 1 + 50 * (1 - std::pow(.5, depth)));
        }
    }

    void fibresCountAsFarAsTheyAreDrawn() {
        CopyExpansion expansion = copiesOfTriangle(2);
        expansion.fibre = {0, 4};
        const CopyDeviation found = deviation(expansion, 100);
        QCOMPARE(found.error, deviation(copiesOfTriangle(2), 100).error + 100);
        QCOMPARE(found.largest, 50.);
    }

    // The size says how large a copy is, the excess how far it goes beyond what it should show.
    void excessBoundsTheError() {
        CopyExpansion expansion = copiesOfTriangle(2);
        expansion.excess = 0.5;
        CopyDeviation found = deviation(expansion, 100);
        QCOMPARE(found.largest, 50.);
        QCOMPARE(found.error, 25 * 0.5 + 1 + 25 + 12.5);
        expansion.excess = 7;
        QCOMPARE(deviation(expansion, 100).error, deviation(copiesOfTriangle(2), 100).error);
    }

    // Of all that is drawn the worst, by the errors of the copies that it is inside of.
    void whatIsMissingIsSummedAlongWords() {
        CopyExpansion expansion = copiesOfTriangle(2);
        expansion.picture.front().missing = 3;
        for (auto& level : expansion.copies)
            for (CopyStep& step : level)
                step.missing = 0.5;
        QCOMPARE(deviation(expansion, 100).missing, 3. + 50 + 25);
        expansion.picture.push_back({Matrix<2>::Identity(), 1, true, 500, 90});
        QCOMPARE(deviation(expansion, 100).missing, 90.);
        QVERIFY(std::isinf(deviation(expansion, 2).missing));
    }

    // It says by itself how far it is off, at every level, and nothing is below it.
    void projectionsAreLeaves() {
        CopyExpansion expansion = copiesOfTriangle(1);
        expansion.picture.push_back({7 * Matrix<2>::Identity(), 1, true, 500});
        const CopyDeviation found = deviation(expansion, 100);
        QCOMPARE(found.error, 500.);
        QCOMPARE(found.largest, 100.);
        QCOMPARE(found.area, deviation(copiesOfTriangle(1), 100).area);
    }

    // 1 + 3 + 9 copies are gone through at depth 2.
    void tooManyHaveNoBound() {
        QVERIFY(std::isfinite(deviation(copiesOfTriangle(2), 13).error));
        QVERIFY(std::isinf(deviation(copiesOfTriangle(2), 11).error));
        QVERIFY(std::isinf(deviation(copiesOfTriangle(2), 11).largest));
        QVERIFY(std::isinf(deviation(copiesOfTriangle(199), 100'000).error));
    }

    void insideComposes() {
        const CopyStep outer{(Matrix<2>() << 0, 2, 1, 0).finished(), 5, false, 3, 1};
        const CopyStep inner{(Matrix<2>() << 1, 1, 0, 1).finished(), 2, true, 0.5, 0.25};
        const CopyStep both = inside(outer, inner);
        QCOMPARE(both.linear, (Matrix<2>() << 0, 2, 1, 1).finished());
        QCOMPARE(both.level, 2);
        QVERIFY(both.isProjection);
        QCOMPARE(both.shift, 4.); // the inner one's by twice as much
        QCOMPARE(both.missing, 1.5);
    }
};

BARYCAGE_TEST(CopyErrorTest);
#include "copy_error_test.moc"
