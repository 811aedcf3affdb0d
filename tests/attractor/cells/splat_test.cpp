// SPDX-License-Identifier: MIT
#include "attractor/cells/splat.h"

#include "attractor/kernels/kernels.h"
#include "attractor/samples/chaos_game.h"
#include "attractor/systems.h"
#include "support/named_test.h"

#include <QtTest>

#include <algorithm>
#include <random>

using namespace attractor;

namespace {

SampleSet samplesOf(const ifs::IteratedFunctionSystem<2>& system) {
    SampleSet samples;
    drawSamples(prepared(system), 2, 0, samples);
    return samples;
}

// Counts one sample after the other.
std::vector<std::uint32_t> plainCounts(const Word& word, const SampleSet& samples, std::uint64_t count,
                                       const CellWindow& window) {
    std::vector<std::uint32_t> counts(window.cells());
    for (std::uint64_t k = 0; k < count; ++k) {
        const float x = samples.x[word.offset + k % SampleSet::size];
        const float y = samples.y[word.offset + k % SampleSet::size];
        const float column = word.xx * x + word.xy * y + word.x;
        const float row = word.yx * x + word.yy * y + word.y;
        if (column >= 0 && column < static_cast<float>(window.width) &&
            row >= static_cast<float>(window.firstRow) && row < static_cast<float>(window.endRow))
            ++counts[static_cast<std::size_t>(static_cast<int>(row) - window.firstRow) *
                         static_cast<std::size_t>(window.width) +
                     static_cast<std::size_t>(column)];
    }
    return counts;
}

Word randomWord(std::mt19937& random, float shrink) {
    std::uniform_real_distribution<float> size(-6, 6);
    std::uniform_real_distribution<float> position(-4, 68);
    return {size(random) * shrink,
            size(random) * shrink,
            size(random) * shrink,
            size(random) * shrink,
            position(random),
            position(random),
            0,
            160,
            1,
            0};
}

Curve randomCurve(std::mt19937& random, float size) {
    std::uniform_real_distribution<float> entry(-size, size);
    return {entry(random), entry(random), entry(random), entry(random), entry(random), entry(random)};
}

std::vector<std::uint32_t> splatted(const ShownWord& shown, const SampleSet& samples,
                                    const CellWindow& window) {
    std::vector<std::uint32_t> counts(window.cells() + overflowCells);
    splat(shown, samples, 1000, window, counts.data());
    counts.resize(window.cells());
    return counts;
}

} // namespace

class TestSplat : public QObject {
    Q_OBJECT

private slots:
    void patchesAndSingleCellsCountLikeTheRest() {
        std::mt19937 random(7);
        const SampleSet samples = samplesOf(systems::maple());
        const CellWindow window{64, 0, 64};
        const std::string chosen = simdName();
        for (int n = 0; n < 300; ++n) {
            const Word word = randomWord(random, n % 3 == 0 ? 0.05F : 1.0F);
            const std::uint64_t count = n % 2 == 0 ? 777 : 20'000;
            const std::vector<std::uint32_t> plain = plainCounts(word, samples, count, window);
            for (const std::string& name : simdNames()) {
                QVERIFY(selectSimd(name));
                std::vector<std::uint32_t> counts(window.cells() + overflowCells);
                splat(word, samples, count, window, counts.data());
                counts.resize(window.cells());
                QVERIFY2(counts == plain, name.c_str());
                std::vector<ColourCell> colours(window.cells() + overflowCells);
                splat(word, samples, count, window, ColourCell{1, 5, 7, 4095}, colours.data());
                for (std::size_t cell = 0; cell < plain.size(); ++cell) {
                    QCOMPARE(colours[cell].samples, plain[cell]);
                    QCOMPARE(colours[cell].blue, 4095 * plain[cell]);
                }
            }
        }
        QVERIFY(selectSimd(chosen));
    }

    // However many samples fall outside the window, its cells are not affected.
    void whatFallsOutsideFillsNothing() {
        SampleSet samples;
        drawSamples(prepared(systems::fern()), 1, 0, samples);
        const CellWindow window{64, 0, 64};
        std::vector<ColourCell> cells(window.cells() + overflowCells);
        const Word word{3000, 0, 0, 3000, 32, 32, 0, 0, 1, 0}; // some of it is inside
        for (int n = 0; n < 100; ++n)
            QVERIFY(!splat(word, samples, 10 * SampleSet::size, window, ColourCell{1, 4095, 4095, 4095},
                           cells.data()));
    }

    // A sum past 2³¹ inside the window has to be carried over.
    void aFullCellIsTold() {
        const SampleSet samples = samplesOf(systems::maple());
        const CellWindow window{4, 0, 4};
        const Word word{0, 0, 0, 0, 1.5F, 2.5F, 0, 0, 1, 0}; // one cell
        std::vector<ColourCell> cells(window.cells() + overflowCells);
        cells[9].red = (1U << 31) - 4095 * 100;
        const ColourCell colour{1, 4095, 0, 0};
        QVERIFY(!splat(word, samples, 99, window, colour, cells.data()));
        QVERIFY(splat(word, samples, 1, window, colour, cells.data()));
        QCOMPARE(cells[9].red, 1U << 31);
        QCOMPARE(cells[9].samples, 100U);
    }

    // Bands of a picture have the rows of the whole, curved words too.
    void bandsAreRowsOfTheWhole() {
        std::mt19937 random(8);
        const SampleSet samples = samplesOf(systems::maple());
        const CellWindow whole{64, 0, 64};
        for (int n = 0; n < 200; ++n) {
            const Word word = randomWord(random, n % 3 == 0 ? 0.05F : 2.0F);
            const Curve curve = randomCurve(random, 3);
            const ShownWord shown(word, n % 2 == 0 ? nullptr : &curve);
            const std::vector<std::uint32_t> expected = splatted(shown, samples, whole);
            for (const CellWindow band :
                 {CellWindow{64, 0, 1}, CellWindow{64, 1, 30}, CellWindow{64, 30, 64}}) {
                const std::vector<std::uint32_t> counts = splatted(shown, samples, band);
                QVERIFY(std::equal(counts.begin(), counts.end(), expected.begin() + band.firstRow * 64));
            }
        }
    }

    // Nothing falls outside the cells that are said to be reached, and nothing falls where none are.
    void reachedCellsHoldAllThatFalls() {
        std::mt19937 random(9);
        const SampleSet samples = samplesOf(systems::fern());
        const CellWindow window{64, 10, 50};
        int met = 0;
        for (int n = 0; n < 1000; ++n) {
            const Word word = randomWord(random, n % 3 == 0 ? 0.05F : 2.0F);
            const Curve curve = randomCurve(random, 3);
            const ShownWord shown(word, n % 2 == 0 ? nullptr : &curve);
            const CellRegion reached = reachedCells(shown, samples, window);
            const std::vector<std::uint32_t> counts = splatted(shown, samples, window);
            const bool any = std::ranges::any_of(counts, [](std::uint32_t count) { return count > 0; });
            const bool isMet = meets(shown, samples, window);
            QVERIFY(isMet || (!any && reached == CellRegion{}));
            met += isMet ? 1 : 0;
            for (int row = window.firstRow; row < window.endRow; ++row)
                for (int column = 0; column < window.width; ++column)
                    if (counts[static_cast<std::size_t>((row - window.firstRow) * window.width + column)] > 0)
                        QVERIFY(column >= reached.firstColumn && column < reached.endColumn &&
                                row >= reached.firstRow && row < reached.endRow);
        }
        QVERIFY(met > 300 && met < 950);
        const Word lost{1, 0, 0, 1, std::nanf(""), 20, 0, 0, 1, 0};
        QVERIFY(splatted(lost, samples, window) == std::vector<std::uint32_t>(window.cells()));
    }
};

BARYCAGE_TEST(TestSplat);
#include "splat_test.moc"
