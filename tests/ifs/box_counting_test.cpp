// SPDX-License-Identifier: MIT
#include "ifs/box_counting.h"
#include "ifs/canonical_systems.h"

#include <QtTest>

#include <numbers>

using namespace ifs;
using namespace canonical;

namespace {

// The points w_σ(x) of all words of one length.
void markWords(CellGrid& grid, const Maps2& maps, const Vector<2>& x, int length) {
    if (length == 0) {
        grid.mark(x);
        return;
    }
    for (const auto& map : maps)
        markWords(grid, maps, map(x), length - 1);
}

double dimensionOf(const Maps2& maps, int levels) {
    const auto grid = occupiedCells(*SupportFunction<2>::of(maps), levels);
    return grid ? fitted(boxCounts(*grid), 2, levels - 1)->slope : -1;
}

} // namespace

class BoxCountingTest : public QObject {
    Q_OBJECT

private slots:
    void powersOfThreeAndFour() {
        CellGrid gasket = emptyGrid({0, 0}, 1, 8), filled = emptyGrid({0, 0}, 1, 6);
        markWords(gasket, sierpinskiRight(), {1. / 3, 1. / 3}, 8);
        markWords(filled, square(), {1. / 3, 1. / 3}, 6);
        const auto counts = boxCounts(gasket), all = boxCounts(filled);
        std::uint64_t power = 1;
        for (int k = 0; k <= 8; ++k, power *= 3)
            QCOMPARE(counts[std::size_t(k)], power);
        for (int k = 0; k <= 6; ++k)
            QCOMPARE(all[std::size_t(k)], std::uint64_t(1) << 2 * k);
        const auto fit = fitted(counts, 0, 8);
        QVERIFY(fit && std::abs(fit->slope - std::log2(3)) < 1e-12);
        QVERIFY(std::abs(fit->intercept) < 1e-12 && fit->deviation < 1e-7);
        QVERIFY(std::abs(fitted(all, 2, 6)->slope - 2) < 1e-12);
    }

    void fitsOnlyWhatIsThere() {
        QVERIFY(!fitted({1, 2, 4}, 1, 3) && !fitted({1, 2, 4}, 1, 1) && !fitted({1, 0, 4}, 0, 2));
        const auto bent = fitted({1, 2, 8}, 0, 2); // ln N / ln 2 = 0, 1, 3
        QVERIFY(bent && std::abs(bent->slope - 1.5) < 1e-12);
        QVERIFY(std::abs(bent->intercept + std::numbers::ln2 / 6) < 1e-12);
        QVERIFY(std::abs(bent->deviation - std::numbers::ln2 * std::sqrt(1. / 18)) < 1e-12);
    }

    void knownDimensions() {
        QVERIFY(std::abs(dimensionOf(sierpinskiEquilateral(), 9) - std::log2(3)) < 0.05);
        QVERIFY(std::abs(dimensionOf(koch(), 9) - std::log(4) / std::log(3)) < 0.05);
        QVERIFY(std::abs(dimensionOf(square(), 7) - 2) < 0.05);
        QVERIFY(std::abs(dimensionOf(flower(), 9) - 1.1925) < 0.05);
    }

    // Every marked cell holds a point, and no point lies farther from one than promised; in little time
    // though the pieces of this system overlap so much that words of small pieces number many millions.
    void everyPointIsNearAMarkedCell() {
        Random random(1);
        const auto support = *SupportFunction<2>::of(maple());
        const auto grid = occupiedCells(support, 7);
        QVERIFY(grid.has_value());
        const int across = 1 << grid->levels;
        CellGrid visited = emptyGrid(grid->origin, grid->side, grid->levels);
        const int reach = 1 + int(0.5 * std::sqrt(2) / (1 - support.contractivity()));
        for (const auto& x : orbit<2>(maple(), 1'000'000, random)) {
            if (!visited.mark(x)) continue;
            const Vector<2> cell = (x - grid->origin) / grid->side * across;
            bool found = false;
            for (int row = int(cell.y()) - reach; row <= int(cell.y()) + reach; ++row)
                for (int column = int(cell.x()) - reach; column <= int(cell.x()) + reach; ++column)
                    found = found || (row >= 0 && column >= 0 && row < across && column < across &&
                                      grid->occupied[std::size_t(row * across + column)]);
            QVERIFY(found);
        }
        const auto marked = boxCounts(*grid), seen = boxCounts(visited);
        QVERIFY(double(seen.back()) > 0.95 * double(marked.back()));
        QVERIFY(double(marked.back()) > 0.95 * double(seen.back()));
        QVERIFY(!occupiedCells(*SupportFunction<2>::of(Maps2{affineMap(.5, 0, 0, .5, 1, 1)}), 5)); // a point
    }
};

QTEST_APPLESS_MAIN(BoxCountingTest)
#include "box_counting_test.moc"
