// SPDX-License-Identifier: MIT
#include "attractor/appearance.h"
#include "attractor/palette.h"

#include "attractor/linear_light.h"

#include <QtTest>

#include <cmath>
#include <set>

using namespace attractor;

namespace {

// Lightness in Oklab, 0 … 1.
double lightness(const Rgba& c) {
    const double r = linearLight(c.red);
    const double g = linearLight(c.green);
    const double b = linearLight(c.blue);
    return 0.2104542553 * std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b) +
           0.7936177850 * std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b) -
           0.0040720468 * std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
}

double distance(const Rgba& a, const Rgba& b) {
    return std::hypot(linearLight(a.red) - linearLight(b.red), linearLight(a.green) - linearLight(b.green),
                      linearLight(a.blue) - linearLight(b.blue));
}

} // namespace

class TestPalette : public QObject {
    Q_OBJECT

private slots:
    void builtInPalettesAreWellFormed() {
        std::set<std::string> names;
        for (const Palette& palette : builtInPalettes()) {
            QVERIFY(names.insert(palette.name).second);
            QVERIFY(palette.stops.size() >= 2);
            QCOMPARE(palette.stops.front().position, 0.0);
            QCOMPARE(palette.stops.back().position, 1.0);
            for (std::size_t i = 1; i < palette.stops.size(); ++i)
                QVERIFY(palette.stops[i - 1].position < palette.stops[i].position);
            QCOMPARE(findPalette(palette.name), &palette);
        }
        QVERIFY(names.size() >= 8);
    }

    void lightnessRunsOneWayInEvenSteps() {
        for (const Palette& palette : builtInPalettes()) {
            const double whole = lightness(colourAt(palette, 1)) - lightness(colourAt(palette, 0));
            QVERIFY2(std::abs(whole) > 0.4, palette.name.c_str());
            for (int k = 0; k < 8; ++k) {
                const double step =
                    lightness(colourAt(palette, (k + 1) / 8.0)) - lightness(colourAt(palette, k / 8.0));
                QVERIFY2(step / whole > 0.03 && step / whole < 0.3, palette.name.c_str());
            }
        }
    }

    void interpolatesInLinearLight() {
        const Palette grey{"grey", {{0, {0, 0, 0, 255}}, {1, {255, 255, 255, 255}}}};
        QCOMPARE(colourAt(grey, 0.5), (Rgba{188, 188, 188, 255}));
        QCOMPARE(colourAt(grey, -1), (Rgba{0, 0, 0, 255}));
        QCOMPARE(colourAt(grey, 2), (Rgba{255, 255, 255, 255}));
    }

    void findsNamesWithoutCase() {
        QCOMPARE(findPalette("mAPLE"), &builtInPalettes().front());
        QVERIFY(findPalette("no such palette") == nullptr);
    }

    void neighbouringCategoriesAreDistinct() {
        for (std::size_t i = 0; i < 24; ++i) {
            QVERIFY(distance(categoricalColour(i), categoricalColour(i + 1)) > 0.2);
            const double light = lightness(categoricalColour(i));
            QVERIFY(light > 0.5 && light < 0.9); // readable on black and on white
        }
    }

    void ownColoursComeFirst() {
        Appearance appearance;
        appearance.mapColours[ifs::MapId{7}] = {1, 2, 3, 255};
        QCOMPARE(mapColour(appearance, ifs::MapId{7}, 0), (Rgba{1, 2, 3, 255}));
        QCOMPARE(mapColour(appearance, ifs::MapId{8}, 4), categoricalColour(4));
    }
};

QTEST_APPLESS_MAIN(TestPalette)
#include "palette_test.moc"
