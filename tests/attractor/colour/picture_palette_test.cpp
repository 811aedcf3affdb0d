// SPDX-License-Identifier: MIT
#include "attractor/colour/picture_palette.h"
#include "support/named_test.h"

#include <QTest>

#include <algorithm>
#include <cstdlib>

using attractor::Palette;
using attractor::Rgba;
using Pixels = std::vector<Rgba>;

namespace {

bool isNear(const Rgba& a, const Rgba& b) {
    return std::abs(a.red - b.red) <= 2 && std::abs(a.green - b.green) <= 2 && std::abs(a.blue - b.blue) <= 2;
}

bool has(const Palette& palette, const Rgba& colour) {
    return std::ranges::any_of(palette.stops, [&](const auto& stop) { return isNear(stop.colour, colour); });
}

constexpr Rgba red{220, 30, 30, 255}, green{20, 160, 40, 255}, blue{20, 30, 200, 255};

} // namespace

// Palettes from pictures.
class PicturePaletteTest : public QObject {
    Q_OBJECT

private slots:
    void findsTheColoursOfAPicture() {
        Pixels pixels(1000, red);
        pixels.insert(pixels.end(), 300, green);
        pixels.insert(pixels.end(), 20, blue); // few, but far from the others
        const Palette palette = attractor::paletteOfPicture(pixels, 3);
        QCOMPARE(palette.stops.size(), std::size_t(3));
        for (const Rgba& colour : {red, green, blue})
            QVERIFY(has(palette, colour));
        QVERIFY(isNear(palette.stops.front().colour, blue)); // the darkest
        QCOMPARE(palette.stops[1].position, .5);
        std::ranges::reverse(pixels);
        QVERIFY(attractor::paletteOfPicture(pixels, 3).stops == palette.stops);
    }

    void keepsTheOrderAlongALine() {
        Pixels pixels(10, green);
        pixels.insert(pixels.end(), 20, red);
        pixels.insert(pixels.end(), 10, blue);
        const Palette palette = attractor::paletteAlongLine(pixels, 3);
        QCOMPARE(palette.stops.size(), std::size_t(3));
        QVERIFY(isNear(palette.stops[0].colour, green) && isNear(palette.stops[1].colour, red) &&
                isNear(palette.stops[2].colour, blue));
        QVERIFY(std::abs(palette.stops[1].position - .5) < .01);
    }

    // The palette is always one that the editor can hold.
    void anyPixelsGiveAPalette_data() {
        QTest::addColumn<int>("count");
        QTest::addColumn<int>("alpha");
        QTest::newRow("none") << 0 << 255;
        QTest::newRow("one") << 1 << 255;
        QTest::newRow("transparent") << 50 << 0;
        QTest::newRow("many") << 5000 << 255;
    }

    void anyPixelsGiveAPalette() {
        QFETCH(int, count);
        QFETCH(int, alpha);
        Pixels pixels;
        for (int k = 0; k < count; ++k)
            pixels.push_back(
                {std::uint8_t(k * 7), std::uint8_t(k * 13), std::uint8_t(k * 29), std::uint8_t(alpha)});
        for (const std::size_t colours : {0, 2, 9, 1000})
            for (const Palette& palette : {attractor::paletteOfPicture(pixels, colours),
                                           attractor::paletteAlongLine(pixels, colours)}) {
                QVERIFY(palette.stops.size() >= 2 && palette.stops.size() <= attractor::maxPictureColours);
                QCOMPARE(palette.stops.front().position, 0.0);
                QCOMPARE(palette.stops.back().position, 1.0);
                QVERIFY(std::ranges::is_sorted(palette.stops, {}, &Palette::Stop::position));
            }
    }
};

BARYCAGE_TEST(PicturePaletteTest);
#include "picture_palette_test.moc"
