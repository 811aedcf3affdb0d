// SPDX-License-Identifier: MIT
#include "attractor/cell_sums.h"

#include "attractor/picture.h"
#include "attractor/systems.h"

#include <QtTest>

#include <numeric>
#include <random>

using namespace attractor;

namespace {

std::uint64_t totalOf(const CellSums& sums) {
    std::uint64_t result = 0;
    std::vector<std::uint64_t> row;
    for (int y = 0; y < sums.window().endRow - sums.window().firstRow; ++y) {
        sums.samplesOfRow(y, row);
        result = std::accumulate(row.begin(), row.end(), result);
    }
    return result;
}

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
            sums.counts(0)[0] = 99; // makes all of the memory dirty
            std::fill_n(sums.counts(1), window.cells(), 99U);
        }
    }

    // From afar all of the fern falls into a few cells, so that refining to more
    // than a 32-bit counter holds takes no time.
    // However much falls beside the window, its cells are as full as they are.
    void whatFallsOutsideFillsNothing() {
        SampleSet samples;
        drawSamples(drawable(systems::fern()), 1, 0, samples);
        const CellWindow window{64, 0, 64};
        std::vector<ColourCell> cells(window.cells() + trashCells);
        const Word word{3000, 0, 0, 3000, 32, 32, 0, 0, 1, 0}; // some of it is inside
        for (int n = 0; n < 100; ++n)
            QVERIFY(!splat(word, samples, 10 * SampleSet::size, window, ColourCell{1, 4095, 4095, 4095},
                           cells.data()));
    }

    void countersNeverWrap_data() {
        QTest::addColumn<int>("colourBy");
        QTest::addColumn<quint64>("samples");
        QTest::newRow("density") << int(ColourBy::Density) << quint64{9'000'000'000};
        QTest::newRow("colours") << int(ColourBy::Map) << quint64{30'000'000};
    }
    void countersNeverWrap() {
        QFETCH(int, colourBy);
        QFETCH(quint64, samples);
        RenderRequest request = systems::request(systems::fern(), samples / 2, 48, 32);
        request.camera.pixelsPerUnit *= 1e-3;
        request.camera.centre += ifs::Vector<2>::Constant(0.4 / request.camera.pixelsPerUnit);
        request.appearance.colourBy = static_cast<ColourBy>(colourBy);
        request.threads = 2;
        Picture picture;
        picture.start(request);
        picture.rewind(0, request.camera.height);
        for (int pass = 0; pass < 2; ++pass) {
            picture.remaining = request.samples;
            QVERIFY(picture.complete({}));
        }
        QVERIFY(picture.drawn > samples - 10);
        QCOMPARE(totalOf(picture.sums), picture.drawn);
        if (picture.sums.kind() == CellKind::Count) {
            QVERIFY(picture.sums.carried());
            return;
        }
        // Every sample has the colour of its first map, so that the sums follow
        // from the words.
        std::uint64_t red = 0;
        std::vector<CellSums::Sum> row;
        for (int y = 0; y < request.camera.height; ++y) {
            picture.sums.sumsOfRow(y, row);
            for (const CellSums::Sum& sum : row)
                red += sum.red;
        }
        double expected = 0;
        for (std::size_t i = 0; i < picture.system.maps.size(); ++i)
            expected += picture.system.probabilities[i] * picture.colours[i].red;
        QVERIFY(red > std::uint64_t{1} << 32);
        QVERIFY(std::abs(static_cast<double>(red) / static_cast<double>(picture.drawn) / expected - 1) <
                1e-3);
    }
};

QTEST_APPLESS_MAIN(TestCellSums)
#include "cell_sums_test.moc"
