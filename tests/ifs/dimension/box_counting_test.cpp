// SPDX-License-Identifier: MIT
#include "ifs/canonical_systems.h"
#include "ifs/dimension/box_counting.h"
#include "support/named_test.h"

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

    // The estimate is near what is known, and says how far it may be off.
    void uncertaintiesAreHonest_data() {
        QTest::addColumn<int>("which");
        QTest::addColumn<double>("dimension");
        const char* names[] = {"dust", "dragon", "gasket", "Koch",
                               "Levy", "square", "flower", "leaning gasket"};
        const double dimensions[] = {std::log(4) / std::log(3), 2,           std::log2(3),
                                     std::log(4) / std::log(3), 2,           2,
                                     1.192493117800738,         std::log2(3)};
        for (int k = 0; k < 8; ++k)
            QTest::newRow(names[k]) << k << dimensions[k];
    }
    void uncertaintiesAreHonest() {
        QFETCH(int, which);
        QFETCH(double, dimension);
        Maps2 dust;
        for (const double x : {0., 2. / 3})
            for (const double y : {0., 2. / 3})
                dust.push_back(affineMap(1. / 3, 0, 0, 1. / 3, x, y));
        const Maps2 all[] = {dust,   heighway(), sierpinskiRight(), koch(),
                             levy(), square(),   flower(),          sierpinskiRight()};
        const auto image = which == 7 ? affineMap(2, .7, .3, 1, 1, 1) : AffineMap<2>{};
        const auto found = boxCounting(*SupportFunction<2>::of(all[which]), image);
        QVERIFY(found.has_value());
        qInfo("%.4f ± %.4f, exactly %.4f, sizes %d to %d", found->fit.slope, found->uncertainty, dimension,
              found->first, found->last);
        QVERIFY(std::abs(found->fit.slope - dimension) <= found->uncertainty);
        QVERIFY(std::abs(found->fit.slope - dimension) <= 0.16);
        QVERIFY(found->uncertainty <= 0.25);
    }

    // Turned by whatever angle, the same to within what is said of either.
    void rotationsChangeNothing_data() {
        QTest::addColumn<int>("which");
        QTest::newRow("gasket") << 0;
        QTest::newRow("Koch") << 1;
        QTest::newRow("flower") << 2;
    }
    void rotationsChangeNothing() {
        QFETCH(int, which);
        const Maps2 all[] = {sierpinskiRight(), koch(), flower()};
        const auto support = *SupportFunction<2>::of(all[which]);
        std::optional<BoxCounting> first;
        for (const int degrees : {0, 7, 23, 37, 45, 60, 77}) {
            const double angle = degrees * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
            const auto found = boxCounting(support, affineMap(c, -s, s, c, 0.3, 0.1));
            QVERIFY(found.has_value());
            if (!first) first = found;
            qInfo("%d°: %.4f ± %.4f", degrees, found->fit.slope, found->uncertainty);
            QVERIFY(std::abs(found->fit.slope - first->fit.slope) <=
                    std::max(found->uncertainty, first->uncertainty));
        }
    }

    // Points followed to the finest cells say nothing of such an attractor.
    void nothingOfWhatHardlyContracts() {
        const double slow = 1 - 1e-6;
        const Maps2 maps{affineMap(slow, 0, 0, .5, 1, 0), affineMap(slow, 0, 0, .25, 3, 1)};
        QVERIFY(!boxCounting(*SupportFunction<2>::of(maps)));
    }

    void theLeastOfSomePlaces() {
        CellGrid middle = emptyGrid({0, 0}, 1, 4); // four cells around the middle: one box when it lies well
        for (const double x : {0.47, 0.53})
            for (const double y : {0.47, 0.53})
                middle.mark({x, y});
        const auto counts = leastBoxCounts(middle);
        QCOMPARE(counts, (std::vector<std::uint64_t>{1, 1, 1, 1}));
        QCOMPARE(boxCounts(middle)[1], std::uint64_t(4));
    }

    // Every marked cell contains a point, and no point is farther from one than the bound; in little time
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

BARYCAGE_TEST(BoxCountingTest);
#include "box_counting_test.moc"
