// SPDX-License-Identifier: MIT
#include "collage/target/nearest_cells.h"
#include "support/named_test.h"

#include <QTest>

#include <random>

using namespace collage;

namespace {

std::int32_t squareBetween(const Mask& mask, int x, int y, std::int32_t cell) {
    const int dx = cell % mask.width - x, dy = cell / mask.width - y;
    return dx * dx + dy * dy;
}

std::int32_t leastSquare(const Mask& mask, int x, int y) {
    std::int32_t least = maxSquare;
    for (std::size_t cell = 0; cell < mask.cells.size(); ++cell)
        if (mask.cells[cell] != 0) least = std::min(least, squareBetween(mask, x, y, std::int32_t(cell)));
    return least;
}

Mask randomMask(std::mt19937& random) {
    Mask mask = emptyMask(1 + int(random() % 40), 1 + int(random() % 40));
    const std::uint32_t rarity = 2 + random() % 60;
    for (std::uint8_t& cell : mask.cells)
        cell = random() % rarity == 0;
    return mask;
}

} // namespace

class NearestCellsTest : public QObject {
    Q_OBJECT

private slots:
    void agreeWithExhaustiveSearch() {
        std::mt19937 random(1);
        for (int trial = 0; trial < 200; ++trial) {
            const Mask mask = randomMask(random);
            const FeatureTransform transform = featureTransform(mask);
            const std::vector<std::int32_t> labels(mask.cells.begin(), mask.cells.end());
            NearestCells nearest;
            nearest.prepare(labels, mask.width, mask.height);
            for (int y = 0; y < mask.height; ++y)
                for (int x = 0; x < mask.width; ++x) {
                    const std::int32_t least = leastSquare(mask, x, y);
                    const std::size_t cell = mask.index(x, y);
                    const NearestCells::Found found = nearest(x, y);
                    QCOMPARE(transform.square[cell], least);
                    QCOMPARE(found.square, least);
                    if (least == maxSquare) continue;
                    QVERIFY(mask.cells[std::size_t(transform.nearest[cell])] != 0);
                    QVERIFY(mask.cells[std::size_t(found.cell)] != 0);
                    QCOMPARE(squareBetween(mask, x, y, transform.nearest[cell]), least);
                    QCOMPARE(squareBetween(mask, x, y, found.cell), least);
                }
        }
    }

    void nothingIsNearestToAnEmptyMask() {
        const FeatureTransform transform = featureTransform(emptyMask(3, 2));
        for (const std::int32_t nearest : transform.nearest)
            QCOMPARE(nearest, -1);
        const std::vector<std::int32_t> labels(6);
        NearestCells nearest;
        nearest.prepare(labels, 3, 2);
        QCOMPARE(nearest(1, 1).cell, -1);
    }
};

BARYCAGE_TEST(NearestCellsTest);
#include "nearest_cells_test.moc"
