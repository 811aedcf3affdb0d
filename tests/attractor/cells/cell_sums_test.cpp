// SPDX-License-Identifier: MIT
#include "attractor/cells/cell_sums.h"
#include "support/named_test.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <fstream>
#include <random>

using namespace attractor;

namespace {

// What pieces() says about a row, added up.
std::vector<std::uint64_t> rowByPieces(const CellSums& sums, int row) {
    std::vector<std::uint64_t> result;
    for (const CellSums::Piece& piece : sums.pieces(row).pieces)
        for (std::size_t x = piece.firstColumn; x < piece.endColumn; ++x) {
            std::uint64_t sum = 0;
            for (const std::uint32_t* counts : piece.counts)
                sum += counts[x - piece.firstColumn];
            result.push_back(sum);
        }
    return result;
}

// Pages of memory that the process occupies, 0 where the system does not tell.
std::uint64_t residentPages() {
    std::ifstream file("/proc/self/statm");
    std::uint64_t size = 0;
    std::uint64_t resident = 0;
    return file >> size >> resident ? resident : 0;
}

} // namespace

class TestCellSums : public QObject {
    Q_OBJECT

private slots:
    // Cells are cleared only where they are asked for; nothing of an earlier use
    // may show anywhere.
    void nothingIsLeftOfAnEarlierUse() {
        constexpr std::size_t threads = 2;
        std::mt19937 random(5);
        CellSums sums;
        for (int round = 0; round < 20; ++round) {
            const CellWindow window{int(random() % 900) + 1, int(random() % 40), 40 + int(random() % 90)};
            sums.reset(CellKind::Count, window, threads);
            std::vector<std::uint64_t> expected(window.cells());
            for (int n = 0; n < 5; ++n) {
                const int x = int(random()) & 1023;
                const int y = int(random()) & 127;
                const CellRegion region{std::min(x, window.width), std::min(x + 70, window.width),
                                        std::clamp(y, window.firstRow, window.endRow),
                                        std::clamp(y + 30, window.firstRow, window.endRow)};
                std::uint32_t* counts = sums.counts(random() % threads, region);
                for (int row = region.firstRow; row < region.endRow; ++row)
                    for (int column = region.firstColumn; column < region.endColumn; ++column) {
                        const auto cell =
                            static_cast<std::size_t>((row - window.firstRow) * window.width + column);
                        counts[cell] += 7;
                        expected[cell] += 7;
                    }
            }
            if (round % 3 == 0) sums.carryOverCounts();
            std::vector<std::uint64_t> row;
            for (int y = 0; y < window.endRow - window.firstRow; ++y) {
                const auto first = expected.begin() + y * window.width;
                const std::vector<std::uint64_t> wanted(first, first + window.width);
                const bool any = sums.samplesOfRow(y, row);
                QVERIFY(row == wanted);
                QVERIFY(any ||
                        std::all_of(row.begin(), row.end(), [](auto samples) { return samples == 0; }));
                if (round % 3 != 0) QVERIFY(rowByPieces(sums, y) == wanted);
            }
            std::vector<std::uint64_t> columns(std::size_t(window.width));
            const int end = window.endRow - window.firstRow, first = end / 3;
            for (auto cell = std::size_t(first) * columns.size(); cell < expected.size(); ++cell)
                columns[cell % columns.size()] += expected[cell];
            sums.samplesOfRows(first, end, row);
            QVERIFY(row == columns);
            sums.counts(0)[0] = 99; // makes all of the memory dirty
            std::fill_n(sums.counts(1), window.cells(), 99U);
        }
    }

    void layersAddUpToColours() {
        const std::array<ColourCell, 3> colours{{{1, 4095, 0, 17}, {1, 3, 4095, 4095}, {1, 0, 0, 1}}};
        std::mt19937 random(7);
        CellSums sums;
        for (int round = 0; round < 6; ++round) {
            const CellWindow window{500 + int(random() % 100), 3, 60};
            sums.reset(CellKind::Colour, window, 2, colours);
            QVERIFY(sums.layered());
            std::vector<CellSums::Sum> expected(window.cells());
            for (int n = 0; n < 9; ++n) {
                const int x = int(random() % 400);
                const int y = window.firstRow + int(random() % 30);
                const std::size_t layer = random() % colours.size();
                std::uint32_t* const counts = sums.layer(random() % 2, layer, {x, x + 90, y, y + 20});
                for (int row = y; row < y + 20; ++row)
                    for (int column = x; column < x + 90; ++column) {
                        const auto cell = std::size_t((row - window.firstRow) * window.width + column);
                        counts[cell] += 1'000'000'000; // whose sums of colours need 64 bits
                        expected[cell].samples += 1'000'000'000;
                        expected[cell].red += 1'000'000'000ULL * colours[layer].red;
                        expected[cell].green += 1'000'000'000ULL * colours[layer].green;
                        expected[cell].blue += 1'000'000'000ULL * colours[layer].blue;
                    }
                if (n % 3 == 2) sums.carryOverCounts(); // three times at most, a counter holds
            }
            std::vector<CellSums::Sum> row;
            std::vector<std::uint64_t> samples;
            for (int y = 0; y < window.endRow - window.firstRow; ++y) {
                sums.sumsOfRow(y, row);
                sums.samplesOfRow(y, samples);
                for (std::size_t x = 0; x < row.size(); ++x) {
                    const CellSums::Sum& wanted = expected[std::size_t(y * window.width) + x];
                    QCOMPARE(samples[x], wanted.samples);
                    QCOMPARE(row[x].samples, wanted.samples);
                    QCOMPARE(row[x].red, wanted.red);
                    QCOMPARE(row[x].green, wanted.green);
                    QCOMPARE(row[x].blue, wanted.blue);
                }
            }
        }
    }

    // Two threads' colours at this size would be half a gigabyte.
    void cellsThatNobodyAsksForTakeNoMemory() {
        if (residentPages() == 0) QSKIP("The system does not tell.");
        CellSums sums;
        const std::uint64_t before = residentPages();
        sums.reset(CellKind::Colour, {8192, 0, 2048}, 2);
        ColourCell* const cells = sums.colours(1, {300, 400, 1000, 1100});
        QCOMPARE(cells[1000 * 8192 + 300].samples, 0U);
        QVERIFY2(residentPages() < before + 16'000, qPrintable(QString::number(residentPages() - before)));
    }
};

BARYCAGE_TEST(TestCellSums);
#include "cell_sums_test.moc"
