// SPDX-License-Identifier: MIT
#include "attractor/colour/palette.h"
#include "attractor/request/appearance.h"

#include "attractor/colour/palette_edits.h"
#include "attractor/colour/srgb_transfer.h"
#include "support/named_test.h"

#include <QtTest>

#include <array>
#include <cmath>
#include <set>

using namespace attractor;

namespace {

using ReferenceOklab = std::array<double, 3>;

ReferenceOklab referenceOklab(const Rgba& colour) {
    const double r = linearLight(colour.red);
    const double g = linearLight(colour.green);
    const double b = linearLight(colour.blue);
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

double difference(const ReferenceOklab& a, const ReferenceOklab& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
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

    void equalStepsLookEqual() {
        constexpr int steps = 16;
        for (const Palette& palette : builtInPalettes()) {
            std::vector<ReferenceOklab> colours;
            for (int k = 0; k <= steps; ++k)
                colours.push_back(referenceOklab(colourAt(palette, double(k) / steps)));
            const double whole = colours.back()[0] - colours.front()[0];
            QVERIFY2(std::abs(whole) > 0.4, palette.name.c_str());
            double length = 0;
            for (std::size_t k = 0; k < steps; ++k)
                length += difference(colours[k], colours[k + 1]);
            for (std::size_t k = 0; k < steps; ++k) {
                const double lightnessStep = (colours[k + 1][0] - colours[k][0]) / whole * steps;
                QVERIFY2(lightnessStep > 0.8 && lightnessStep < 1.2, palette.name.c_str());
                const double step = difference(colours[k], colours[k + 1]) / length * steps;
                QVERIFY2(step > 0.75 && step < 1.45, palette.name.c_str());
            }
        }
    }

    void stopsAreAddedMovedAndRemoved() {
        Palette palette = *findPalette("Maple");
        const Palette before = palette;
        const std::size_t added = addStop(palette, 0.3);
        QCOMPARE(added, std::size_t{4});
        QCOMPARE(palette.stops[added], (Palette::Stop{0.3, colourAt(before, 0.3)}));
        for (double t = 0; t <= 1; t += 0.01)
            QVERIFY(distance(colourAt(palette, t), colourAt(before, t)) < 0.01);
        moveStop(palette, added, 0.9);
        QCOMPARE(palette.stops[added].position, palette.stops[added + 1].position);
        moveStop(palette, added, -5);
        QCOMPARE(palette.stops[added].position, palette.stops[added - 1].position);
        removeStop(palette, added);
        QVERIFY(palette == before);
        for (const std::size_t end : {std::size_t{0}, palette.stops.size() - 1}) {
            QVERIFY(!canMove(palette, end));
            moveStop(palette, end, 0.5);
            removeStop(palette, end);
        }
        QVERIFY(palette == before);
        QCOMPARE(addStop(palette, 2), before.stops.size() - 1);
        QCOMPARE(addStop(palette, -2), std::size_t{1});
    }

    void palettesAreReversedAndDistributed() {
        Palette palette = *findPalette("Dusk");
        const Palette before = palette;
        reverse(palette);
        for (double t = 0; t <= 1; t += 0.01)
            QVERIFY(distance(colourAt(palette, t), colourAt(before, 1 - t)) < 0.01);
        reverse(palette);
        for (std::size_t i = 0; i < palette.stops.size(); ++i)
            QVERIFY(std::abs(palette.stops[i].position - before.stops[i].position) < 1e-15);
        distribute(palette);
        for (std::size_t i = 0; i < palette.stops.size(); ++i) {
            QCOMPARE(palette.stops[i].position, double(i) / 8);
            QCOMPARE(palette.stops[i].colour, before.stops[i].colour);
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
            const double light = referenceOklab(categoricalColour(i))[0];
            QVERIFY(light > 0.5 && light < 0.9); // readable on black and on white
        }
    }

    void ownColoursComeFirst() {
        Appearance appearance;
        appearance.mapColours[ifs::MapId{7}] = {1, 2, 3, 255};
        QCOMPARE(mapColour(appearance, ifs::MapId{7}, 0), (Rgba{1, 2, 3, 255}));
        QCOMPARE(mapColour(appearance, ifs::MapId{8}, 4), categoricalColour(4));
    }

    void coloursOfMapsAreKeptById() {
        MapColours colours;
        QVERIFY(colours.empty());
        for (const std::uint8_t id : {9, 2, 14, 5}) // in any order
            colours[ifs::MapId{id}] = {id, 0, 0, 255};
        colours[ifs::MapId{2}].green = 1;
        for (const std::uint8_t id : {5, 9, 14})
            QCOMPARE(*colours.find(ifs::MapId{id}), (Rgba{id, 0, 0, 255}));
        QCOMPARE(*colours.find(ifs::MapId{2}), (Rgba{2, 1, 0, 255}));
        for (const std::uint32_t id : {0, 3, 15})
            QVERIFY(!colours.find(ifs::MapId{id}));

        MapColours others; // the same given in another order
        for (const std::uint8_t id : {14, 5, 9})
            others[ifs::MapId{id}] = {id, 0, 0, 255};
        QVERIFY(!(colours == others));
        colours.eraseIf([](ifs::MapId id) { return id == ifs::MapId{2}; });
        QVERIFY(!colours.find(ifs::MapId{2}));
        QVERIFY(colours == others);
    }
};

BARYCAGE_TEST(TestPalette);
#include "palette_test.moc"
