// SPDX-License-Identifier: MIT
#include "attractor/light/tone_map.h"

#include "attractor/light/tone_map16.h"
#include "support/named_test.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>

using namespace attractor;

namespace {

// In double precision, by the formulas of docs/mathematics.md, "Density to colour", with the functions of the
// mathematical library.
double toneByFormula(double density, double brightness, double whitePoint, double gamma) {
    return std::clamp(
        std::pow(std::log(1 + brightness * density) / std::log(1 + brightness * whitePoint), 1 / gamma), 0.0,
        1.0);
}
double linearByFormula(double code) {
    return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}
double codeByFormula(double linear) {
    return linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

// Window of width × height cells with counts up to `max`, every third cell empty.
std::vector<std::uint32_t> fill(CellSums& sums, int width, int height, std::uint32_t max) {
    sums.reset(CellKind::Count, {width, 0, height}, 2);
    std::mt19937 random(21);
    std::vector<std::uint32_t> total;
    std::uint32_t* const first = sums.counts(0);
    std::uint32_t* const second = sums.counts(1);
    for (std::size_t cell = 0; cell < sums.window().cells(); ++cell) {
        const auto count = random() % 3 == 0 ? 0U : static_cast<std::uint32_t>(random() % (max + 1));
        first[cell] = count / 3;
        second[cell] = count - count / 3;
        total.push_back(count);
    }
    return total;
}

ToneSettings settings(int cellsPerPixel) {
    ToneSettings result;
    result.appearance.colourBy = ColourBy::Plain;
    result.appearance.plain = {200, 120, 40, 255};
    result.appearance.background = {10, 30, 60, 255};
    result.appearance.supersample = cellsPerPixel;
    result.cellsPerPixel = cellsPerPixel;
    result.densityPerSample = 0.05;
    result.whitePoint = 5;
    result.gain = 1.25;
    return result;
}

// A channel of 256 levels.
double vibrantByFormula(const ToneSettings& s, double level) {
    const double kept = s.appearance.vibrancy;
    return kept * level + (1 - kept) * 255 * std::pow(level / 255, 1 / s.appearance.gamma);
}

// Alpha of a pixel with these cells.
double alphaByFormula(const ToneSettings& s, const std::vector<std::uint32_t>& cells) {
    const auto alpha = [&](std::uint32_t count) {
        const double v = toneByFormula(count * s.densityPerSample, s.appearance.brightness, s.whitePoint,
                                       s.appearance.gamma);
        const double light = std::pow(v, s.appearance.contrast);
        return light / (light + std::pow(1 - v, s.appearance.contrast));
    };
    if (cells.size() == 1) return alpha(cells[0]);
    double light = 0;
    for (const std::uint32_t count : cells)
        light += linearByFormula(alpha(count));
    return codeByFormula(std::min(1.0, s.gain * light / static_cast<double>(cells.size())));
}

std::vector<std::uint32_t> cellsOfPixel(const std::vector<std::uint32_t>& counts, int width, int side, int x,
                                        int y) {
    std::vector<std::uint32_t> cells;
    for (int row = y * side; row < (y + 1) * side; ++row)
        for (int column = x * side; column < (x + 1) * side; ++column)
            cells.push_back(counts[static_cast<std::size_t>(row * width + column)]);
    return cells;
}

} // namespace

class TestToneMap : public QObject {
    Q_OBJECT

private slots:
    void theCurveIsTheFormula() {
        std::mt19937 random(20);
        std::uniform_real_distribution<double> exponent(-6, 4);
        for (int n = 0; n < 10'000; ++n) {
            const double density = std::pow(10.0, exponent(random));
            const double brightness = std::pow(10.0, exponent(random) / 2);
            const double whitePoint = 4 + std::pow(10.0, exponent(random) / 2);
            const double gamma = 0.5 + std::abs(exponent(random));
            QVERIFY(std::abs(tone(density, brightness, whitePoint, gamma) -
                             toneByFormula(density, brightness, whitePoint, gamma)) < 1e-11);
        }
        QCOMPARE(tone(0, 20, 5, 2.2), 0.0);
        QCOMPARE(tone(50, 20, 5, 2.2), 1.0);
    }

    void pixelsFollowTheFormula_data() {
        QTest::addColumn<int>("side");
        QTest::addColumn<double>("contrast");
        QTest::addColumn<double>("vibrancy");
        QTest::newRow("a cell a pixel") << 1 << 1.0 << 1.0;
        QTest::newRow("4 cells a pixel") << 2 << 1.0 << 1.0;
        QTest::newRow("9 cells a pixel") << 3 << 1.0 << 1.0;
        QTest::newRow("contrast") << 1 << 2.5 << 1.0;
        QTest::newRow("little contrast, 4 cells a pixel") << 2 << 0.4 << 1.0;
        QTest::newRow("vibrancy") << 1 << 1.0 << 0.3;
        QTest::newRow("both, 9 cells a pixel") << 3 << 2.0 << 0.0;
    }
    void pixelsFollowTheFormula() {
        QFETCH(int, side);
        constexpr int width = 40;
        constexpr int height = 30;
        CellSums sums;
        const std::vector<std::uint32_t> counts = fill(sums, width * side, height * side, 120);
        ToneSettings s = settings(side);
        QFETCH(double, contrast);
        QFETCH(double, vibrancy);
        s.appearance.contrast = contrast;
        s.appearance.vibrancy = vibrancy;
        std::vector<std::uint32_t> pixels(width * height);
        const ToneMap toneMap(s, 1000);
        toneMap.apply(sums, 0, 11, pixels);
        toneMap.apply(sums, 11, height, pixels);
        std::vector<Rgba16> deep(width * height);
        ToneMap16(s).apply(sums, 0, height, deep);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const auto cells = cellsOfPixel(counts, width * side, side, x, y);
                const double alpha = alphaByFormula(s, cells);
                const auto composed = [&](int front, int back) {
                    return alpha * vibrantByFormula(s, front) + (1 - alpha) * back;
                };
                const std::uint32_t pixel = pixels[static_cast<std::size_t>(y * width + x)];
                QCOMPARE(pixel >> 24, 255U);
                const Rgba& a = s.appearance.plain;
                const Rgba& b = s.appearance.background;
                const double red = composed(a.red, b.red);
                const double green = composed(a.green, b.green);
                const double blue = composed(a.blue, b.blue);
                // Light has 12 bits on the way to 8.
                const double step = (side == 1 ? 0.6 : 1.6) + (vibrancy < 1 ? 0.5 : 0);
                QVERIFY(std::abs((pixel >> 16 & 255U) - red) < step);
                QVERIFY(std::abs((pixel >> 8 & 255U) - green) < step);
                QVERIFY(std::abs((pixel & 255U) - blue) < step);
                const Rgba16& wide = deep[static_cast<std::size_t>(y * width + x)];
                QVERIFY(std::abs(wide.red - 257 * red) < 0.51);
                QVERIFY(std::abs(wide.green - 257 * green) < 0.51);
                QVERIFY(std::abs(wide.blue - 257 * blue) < 0.51);
                QCOMPARE(wide.alpha, std::uint16_t(65535));
            }
    }

    // Colours that samples have of their own: the mean of each cell, in linear light.
    void ownColoursFollowTheFormula() {
        constexpr int width = 64;
        CellSums sums;
        sums.reset(CellKind::Colour, {width, 0, 1}, 1);
        std::mt19937 random(22);
        std::vector<CellSums::Sum> cells(width);
        for (CellSums::Sum& cell : cells) {
            cell.samples = 1 + random() % (random() % 2 == 0 ? 60 : 1000);
            for (std::uint64_t* channel : {&cell.red, &cell.green, &cell.blue})
                *channel = cell.samples * (random() % 4096);
        }
        sums.addSums(0, 0, cells);
        for (const double vibrancy : {1.0, 0.6, 0.0})
            for (const ColourBy colourBy : {ColourBy::Map, ColourBy::Address}) {
                ToneSettings s = settings(1);
                s.appearance.colourBy = colourBy;
                s.appearance.contrast = 1.7;
                s.appearance.vibrancy = vibrancy;
                std::vector<std::uint32_t> pixels(width);
                std::vector<Rgba16> deep(width);
                ToneMap(s, 1000).apply(sums, 0, 1, pixels);
                ToneMap16(s).apply(sums, 0, 1, deep);
                for (std::size_t x = 0; x < width; ++x) {
                    const CellSums::Sum& cell = cells[x];
                    const double alpha = alphaByFormula(s, {static_cast<std::uint32_t>(cell.samples)});
                    const auto level = [&](std::uint64_t sum, int back) {
                        const double light = double(sum) / (double(cell.samples) * 4095);
                        return alpha * vibrantByFormula(s, 255 * codeByFormula(light)) + (1 - alpha) * back;
                    };
                    const double red = level(cell.red, s.appearance.background.red);
                    const double blue = level(cell.blue, s.appearance.background.blue);
                    QVERIFY(std::abs((pixels[x] >> 16 & 255U) - red) < 1.1);
                    QVERIFY(std::abs((pixels[x] & 255U) - blue) < 1.1);
                    QVERIFY(std::abs(deep[x].red - 257 * red) < 0.51);
                    QVERIFY(std::abs(deep[x].blue - 257 * blue) < 0.51);
                }
            }
    }

    // Sums that have been carried over take another way to the same pixels.
    void carriedCountsLookAlike() {
        for (const ColourBy colourBy : {ColourBy::Plain, ColourBy::Density}) {
            CellSums sums;
            fill(sums, 300, 40, 100'000);
            ToneSettings s = settings(1);
            s.appearance.colourBy = colourBy;
            s.densityPerSample = 1e-4;
            s.appearance.vibrancy = colourBy == ColourBy::Plain ? 0.4 : 1;
            const ToneMap toneMap(s, 100'000);
            std::vector<std::uint32_t> before(300 * 40);
            std::vector<std::uint32_t> after(300 * 40);
            toneMap.apply(sums, 0, 40, before);
            sums.carryOverCounts();
            toneMap.apply(sums, 0, 40, after);
            for (std::size_t k = 0; k < before.size(); ++k)
                for (const int shift : {0, 8, 16, 24})
                    QVERIFY(std::abs(int(before[k] >> shift & 255U) - int(after[k] >> shift & 255U)) <= 1);
            QVERIFY(std::ranges::adjacent_find(before, std::not_equal_to<>()) != before.end());
        }
    }

    // A picture that is laid over a background by a viewer is the picture drawn on it.
    void transparentPicturesCompose() {
        CellSums sums;
        fill(sums, 100, 20, 120);
        ToneSettings on = settings(1);
        ToneSettings clear = on;
        clear.appearance.background.alpha = 0;
        std::vector<std::uint32_t> drawn(2000);
        std::vector<std::uint32_t> over(2000);
        ToneMap(on, 120).apply(sums, 0, 20, drawn);
        ToneMap(clear, 120).apply(sums, 0, 20, over);
        for (std::size_t k = 0; k < drawn.size(); ++k) {
            const double behind = 1 - (over[k] >> 24) / 255.0;
            QVERIFY(std::abs((over[k] >> 16 & 255U) + behind * 10 - (drawn[k] >> 16 & 255U)) <= 1.1);
            QVERIFY(std::abs((over[k] & 255U) + behind * 60 - (drawn[k] & 255U)) <= 1.1);
        }
    }

    // An even measure: found ∕ occupied ∕ samples with rarefaction, 1 − (1 − share)ᶜ of the pixels.
    void exposureOfAnEvenMeasure() {
        constexpr std::uint32_t each = 7;
        constexpr int side = 100;
        CellSums sums;
        sums.reset(CellKind::Count, {side, 0, side}, 1);
        std::fill_n(sums.counts(0), side * side, each);
        Workers workers(2);
        const double samples = 3.0 * each * side * side; // a third of them in view
        Appearance look;
        const Exposure exposure = measuredExposure(sums, look, samples, std::nullopt, workers);
        const double found = each * side * side;
        const double share = 0.5 * side * side / found;
        const double occupied = side * side * (1 - std::pow(1 - share, each));
        QVERIFY(std::abs(exposure.meanDensity / (found / occupied / samples) - 1) < 1e-12);
        QCOMPARE(exposure.whitePoint, 4.0);
        QCOMPARE(exposure.gain, 1.0);
        const Occupancy all = occupancy(sums, 1, 1, workers);
        QCOMPARE(all.samples, found);
        QCOMPARE(all.occupied, double(side * side));
        const Exposure kept = measuredExposure(sums, look, samples, Exposure{99, 8, 2}, workers);
        QCOMPARE(kept, (Exposure{exposure.meanDensity, 8, 2}));
    }

    // The 99.5 percentile over blocks that hold 64 samples on average at the share that is compared, whatever
    // the number of threads.
    void theWhitePointIsThatOfBlocks() {
        constexpr int width = 403, height = 202;
        CellSums sums;
        std::vector<std::uint32_t> cells = fill(sums, width, height, 3);
        std::uint32_t* const counts = sums.counts(1);
        for (int y = 50; y < 82; ++y) // bright
            for (int x = 101; x < 140; ++x) {
                counts[y * width + x] += 120;
                cells[std::size_t(y * width + x)] += 120;
            }
        const double found = std::accumulate(cells.begin(), cells.end(), 0.0);
        const double share = 0.5 * width * height / found;
        const auto occupied = [share](const auto& of) {
            return std::accumulate(of.begin(), of.end(), 0.0, [share](double sum, auto count) {
                return sum + 1 - std::pow(1 - share, double(count));
            });
        };
        const double perPixel = share * found / occupied(cells);
        int side = 1;
        while (perPixel * side * side < 64)
            side *= 2;
        QCOMPARE(side, 8);
        std::vector<std::uint64_t> blocks(64 * 64);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                blocks[std::size_t(y / side * 64 + x / side)] += cells[std::size_t(y * width + x)];
        std::erase(blocks, 0);
        std::ranges::sort(blocks, std::greater<>());
        const double all = occupied(blocks);
        const double wanted = double(blocks[std::size_t(0.005 * all)]) * all / found;
        QVERIFY(wanted > 5);
        Appearance look;
        for (const std::size_t threads : {1, 2, 3, 8}) {
            Workers workers(threads);
            const Exposure exposure = measuredExposure(sums, look, found, std::nullopt, workers);
            QVERIFY(std::abs(exposure.whitePoint / wanted - 1) < 1e-12);
        }
    }
};

BARYCAGE_TEST(TestToneMap);
#include "tone_map_test.moc"
