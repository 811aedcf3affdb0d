// SPDX-License-Identifier: MIT
#include "attractor/kernels/kernels.h"
#include "support/named_test.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

using namespace attractor;

namespace {

// Points as long as a kernel may read, with some that are beyond all windows or no numbers at all.
struct Points {
    std::vector<float> x;
    std::vector<float> y;

    explicit Points(std::mt19937& random, std::size_t count, bool withOutliers) {
        std::uniform_real_distribution<float> position(-1, 1);
        const std::size_t size = (count / kernels::chunk + 1) * kernels::chunk;
        for (std::size_t i = 0; i < size; ++i) {
            x.push_back(position(random));
            y.push_back(position(random));
        }
        if (!withOutliers) return;
        constexpr float infinity = std::numeric_limits<float>::infinity();
        const float odd[] = {std::nanf(""), infinity, -infinity, 3e38F, 1e20F, -1e20F};
        for (std::size_t i = 0; i < size; i += 5)
            (i % 2 == 0 ? x : y)[i] = odd[i % std::size(odd)];
    }
    kernels::Run run(std::size_t count) const { return {x.data(), y.data(), count}; }
};

struct Position {
    float column = 0;
    float row = 0;
};

// In the order that the kernels promise, so that every rounding is the same.
Position positionOf(const ShownWord& shown, float a, float b) {
    const Word& w = shown.word;
    if (shown.curve == nullptr) return {w.xx * a + w.xy * b + w.x, w.yx * a + w.yy * b + w.y};
    const Curve& c = *shown.curve;
    const auto second = [&](float aa, float ab, float bb, float p, float q) {
        return (aa * a + ab * b + p) * a + (bb * b + q) * b;
    };
    return {second(c.xaa, c.xab, c.xbb, w.xx, w.xy) + w.x, second(c.yaa, c.yab, c.ybb, w.yx, w.yy) + w.y};
}

// The cell of every point; window.cells() for those outside.
std::vector<std::size_t> cellsOf(const ShownWord& shown, const kernels::Run& run, const CellWindow& window) {
    std::vector<std::size_t> cells;
    for (std::size_t i = 0; i < run.count; ++i) {
        const Position at = positionOf(shown, run.x[i], run.y[i]);
        const bool inside = at.column >= 0 && at.column < static_cast<float>(window.width) &&
                            at.row >= static_cast<float>(window.firstRow) &&
                            at.row < static_cast<float>(window.endRow);
        cells.push_back(inside ? static_cast<std::size_t>(static_cast<int>(at.row) - window.firstRow) *
                                         static_cast<std::size_t>(window.width) +
                                     static_cast<std::size_t>(at.column)
                               : window.cells());
    }
    return cells;
}

std::vector<std::uint32_t> countsOf(const std::vector<std::size_t>& cells, const CellWindow& window) {
    std::vector<std::uint32_t> counts(window.cells() + 1);
    for (const std::size_t cell : cells)
        ++counts[cell];
    return counts;
}

Word randomWord(std::mt19937& random, float size, const CellWindow& window) {
    std::uniform_real_distribution<float> entry(-size, size);
    std::uniform_real_distribution<float> column(0, static_cast<float>(window.width));
    std::uniform_real_distribution<float> row(static_cast<float>(window.firstRow),
                                              static_cast<float>(window.endRow));
    return {
        entry(random), entry(random), entry(random), entry(random), column(random), row(random), 0, 0, 1, 0};
}

Curve randomCurve(std::mt19937& random, float size) {
    std::uniform_real_distribution<float> entry(-size, size);
    return {entry(random), entry(random), entry(random), entry(random), entry(random), entry(random)};
}

constexpr std::size_t runLengths[] = {0, 1, 127, 128, 129, 255, 256, 257, 1000};

} // namespace

class TestKernels : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { m_chosen = simdName(); }
    void cleanup() { QVERIFY(selectSimd(m_chosen)); }

    void instructionSets_data() {
        QTest::addColumn<QString>("name");
        for (const std::string& name : simdNames())
            QTest::newRow(name.c_str()) << QString::fromStdString(name);
    }
    void instructionSets() {
        QFETCH(QString, name);
        QVERIFY(selectSimd(name.toStdString()));
        // Two names may stand for one set.
        QVERIFY(simdName() == name.toStdString() ||
                (name == QLatin1String("avx3") && simdName() == "avx512"));
        QVERIFY(!selectSimd("abacus"));
    }

    // Wherever the points fall, in windows that begin anywhere: those outside go to the overflow cells.
    void countsAreThoseOfOnePointAtATime_data() { instructionSets_data(); }
    void countsAreThoseOfOnePointAtATime() {
        QFETCH(QString, name);
        QVERIFY(selectSimd(name.toStdString()));
        std::mt19937 random(11);
        for (const CellWindow window : {CellWindow{64, 0, 64}, CellWindow{37, 100, 131}, CellWindow{1, 5, 6}})
            for (const std::size_t length : runLengths)
                for (int n = 0; n < 20; ++n) {
                    const Points points(random, length, n % 2 == 1);
                    const Word word = randomWord(random, n % 3 == 0 ? 3 : 60, window);
                    const Curve curve = randomCurve(random, 20);
                    const ShownWord shown(word, n % 4 < 2 ? nullptr : &curve);
                    const kernels::Run run = points.run(length);
                    const auto expected = countsOf(cellsOf(shown, run, window), window);
                    std::vector<std::uint32_t> counts(window.cells() + overflowCells);
                    kernels::addToCounts(shown, run, window, counts.data());
                    const auto outside = counts.begin() + static_cast<std::ptrdiff_t>(window.cells());
                    QCOMPARE(std::accumulate(outside, counts.end(), 0U), expected.back());
                    QVERIFY(std::equal(counts.begin(), outside, expected.begin()));
                }
    }

    // The edges of the window belong to it on the left and above, not on the right and below.
    void edges_data() { instructionSets_data(); }
    void edges() {
        QFETCH(QString, name);
        QVERIFY(selectSimd(name.toStdString()));
        const CellWindow window{8, 4, 12};
        const Word word{1, 0, 0, 1, 0, 0, 0, 0, 1, 0}; // points are cells
        Points points(m_random, kernels::chunk, false);
        const float positions[] = {
            -0.0F, std::nextafter(0.0F, -1.0F), 7.9999995F, 8, 3.9999998F, 4, 11.999999F, 12};
        std::size_t count = 0;
        for (const float column : positions)
            for (const float row : positions) {
                points.x[count] = column;
                points.y[count] = row;
                ++count;
            }
        const kernels::Run run = points.run(count);
        const auto expected = countsOf(cellsOf(word, run, window), window);
        QVERIFY(expected[0] > 0 && expected[window.cells() - 1] > 0 && expected.back() > 0);
        std::vector<std::uint32_t> counts(window.cells() + overflowCells);
        kernels::addToCounts(word, run, window, counts.data());
        QVERIFY(std::equal(expected.begin(), expected.end() - 1, counts.begin()));
    }

    void runsInsideNeedNoCare_data() { instructionSets_data(); }
    void runsInsideNeedNoCare() {
        QFETCH(QString, name);
        QVERIFY(selectSimd(name.toStdString()));
        std::mt19937 random(12);
        const CellWindow window{90, 40, 130};
        for (const std::size_t length : runLengths)
            for (int n = 0; n < 20; ++n) {
                const Points points(random, length, false);
                Word word = randomWord(random, 10, window);
                word.x = 45; // |x| ≤ 40 from here
                word.y = 85;
                const Curve curve = randomCurve(random, 6);
                const ShownWord shown(word, n % 2 == 0 ? nullptr : &curve);
                const kernels::Run run = points.run(length);
                const auto expected = countsOf(cellsOf(shown, run, window), window);
                QCOMPARE(expected.back(), 0U);
                std::vector<std::uint32_t> counts(window.cells() + 1);
                kernels::addInside(shown, run, window, counts.data());
                QVERIFY(counts == expected);
            }
    }

    void patchesAddUp_data() { instructionSets_data(); }
    void patchesAddUp() {
        QFETCH(QString, name);
        QVERIFY(selectSimd(name.toStdString()));
        std::mt19937 random(13);
        const CellWindow window{50, 10, 60};
        for (const std::size_t length : runLengths)
            for (int n = 0; n < 20; ++n) {
                const Points points(random, length, false);
                Word word = randomWord(random, 3, window);
                word.x = 20.5F; // |x| ≤ 6 from here
                word.y = 30.5F;
                const kernels::Run run = points.run(length);
                const kernels::Patch patch{14, 24, 13, 13};
                QVERIFY(patch.width * patch.height <= kernels::patchCells);
                const auto expected = countsOf(cellsOf(word, run, window), window);
                std::vector<std::uint32_t> counts(window.cells() + 1);
                kernels::addToPatch(word, run, patch, window, counts.data());
                QVERIFY(counts == expected);
            }
    }

    // The bits that come back are those that any sum has had, in the overflow cells too.
    void coloursAddUp_data() { instructionSets_data(); }
    void coloursAddUp() {
        QFETCH(QString, name);
        QVERIFY(selectSimd(name.toStdString()));
        std::mt19937 random(14);
        const CellWindow window{37, 100, 131};
        const ColourCell colour{1, 4095, 17, 0};
        for (const std::size_t length : runLengths)
            for (int n = 0; n < 20; ++n) {
                const Points points(random, length, n % 2 == 1);
                const Word word = randomWord(random, 30, window);
                const Curve curve = randomCurve(random, 20);
                const ShownWord shown(word, n % 4 < 2 ? nullptr : &curve);
                const kernels::Run run = points.run(length);
                const std::uint32_t filled = n % 5 == 0 ? 0x7fffff00U : 1000; // before
                std::vector<ColourCell> cells(window.cells() + overflowCells, {filled, filled, 3, 5});
                const auto expected = countsOf(cellsOf(shown, run, window), window);
                const std::uint32_t bits = kernels::addToColours(shown, run, window, colour, cells.data());
                std::uint32_t inWindow = 0;
                for (std::size_t cell = 0; cell < window.cells(); ++cell) {
                    const std::uint32_t count = expected[cell];
                    QCOMPARE(cells[cell].samples, filled + count);
                    QCOMPARE(cells[cell].red, filled + 4095 * count);
                    QCOMPARE(cells[cell].green, 3 + 17 * count);
                    QCOMPARE(cells[cell].blue, 5U);
                    for (std::uint32_t k = 1; k <= count; ++k)
                        inWindow |= (filled + k) | (filled + 4095 * k) | (3 + 17 * k) | 5;
                }
                QCOMPARE(bits & inWindow, inWindow);
                if (expected.back() == 0) QCOMPARE(bits, inWindow);
                if (n % 5 == 0 && inWindow != 0) QVERIFY(bits >> 31 != 0);
            }
    }

    void coloursInsideNeedNoCare_data() { instructionSets_data(); }
    void coloursInsideNeedNoCare() {
        QFETCH(QString, name);
        QVERIFY(selectSimd(name.toStdString()));
        std::mt19937 random(16);
        const CellWindow window{90, 40, 130};
        const ColourCell colour{1, 4095, 17, 0};
        for (const std::size_t length : runLengths)
            for (int n = 0; n < 20; ++n) {
                const Points points(random, length, false);
                Word word = randomWord(random, 10, window);
                word.x = 45; // |x| ≤ 40 from here
                word.y = 85;
                const Curve curve = randomCurve(random, 6);
                const ShownWord shown(word, n % 2 == 0 ? nullptr : &curve);
                const kernels::Run run = points.run(length);
                const auto expected = countsOf(cellsOf(shown, run, window), window);
                std::vector<ColourCell> cells(window.cells(), {3, 5, 7, 9});
                std::vector<ColourCell> anywhere(window.cells() + overflowCells, {3, 5, 7, 9});
                QCOMPARE(kernels::addToColoursInside(shown, run, window, colour, cells.data()),
                         kernels::addToColours(shown, run, window, colour, anywhere.data()));
                for (std::size_t cell = 0; cell < window.cells(); ++cell) {
                    QCOMPARE(cells[cell].samples, 3 + expected[cell]);
                    QCOMPARE(cells[cell].red, 5 + 4095 * expected[cell]);
                    QCOMPARE(cells[cell].green, 7 + 17 * expected[cell]);
                    QCOMPARE(cells[cell].blue, 9U);
                }
            }
    }

    // Below 128 the count itself; then 64 steps to every power of two of the count as a float.
    void toneIndicesByTheLogarithm() {
        for (std::uint64_t n = 0; n < 128; ++n)
            QCOMPARE(kernels::toneIndex(n), std::size_t(n));
        std::mt19937_64 random(15);
        for (int k = 0; k < 100'000; ++k) {
            const std::uint64_t n = std::max<std::uint64_t>(128, random() >> (k % 57));
            int exponent = 0;
            const double fraction = std::frexp(static_cast<double>(static_cast<float>(n)), &exponent);
            const double step = std::floor((2 * fraction - 1) * 64);
            QCOMPARE(kernels::toneIndex(n), std::size_t(128 + 64 * (exponent - 1 - 7) + int(step)));
        }
    }

    void tonesOfTheSumOfAllThreads_data() { instructionSets_data(); }
    void tonesOfTheSumOfAllThreads() {
        QFETCH(QString, name);
        QVERIFY(selectSimd(name.toStdString()));
        std::mt19937 random(16);
        std::vector<std::uint32_t> palette(kernels::toneIndex((std::uint64_t{1} << 31) - 1) + 1);
        for (std::uint32_t& colour : palette)
            colour = static_cast<std::uint32_t>(random());
        for (const std::size_t threads : {0U, 1U, 2U, 3U})
            for (const std::size_t size : {1U, 15U, 16U, 17U, 200U}) {
                std::vector<std::vector<std::uint32_t>> counts(threads, std::vector<std::uint32_t>(size));
                std::vector<const std::uint32_t*> pointers;
                for (auto& of : counts) {
                    for (std::uint32_t& count : of) // the sum stays below 2³¹
                        count = random() % 3 == 0
                                    ? 0
                                    : static_cast<std::uint32_t>(random() % (1U << 29)) >> (random() % 29);
                    pointers.push_back(of.data());
                }
                std::vector<std::uint32_t> pixels(size + 1, 12345);
                kernels::mapTones(pointers, size, palette.data(), pixels.data());
                for (std::size_t k = 0; k < size; ++k) {
                    std::uint64_t sum = 0;
                    for (const auto& of : counts)
                        sum += of[k];
                    QCOMPARE(pixels[k], palette[kernels::toneIndex(sum)]);
                }
                QCOMPARE(pixels[size], 12345U);
            }
    }

private:
    std::string m_chosen;
    std::mt19937 m_random{17};
};

BARYCAGE_TEST(TestKernels);
#include "kernels_test.moc"
