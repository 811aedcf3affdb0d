// SPDX-License-Identifier: MIT
#include "attractor/colour/palette_library.h"

#include "attractor/colour/oklab.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>
#include <set>

using namespace attractor;

namespace {

double lightness(const Palette& palette, double position) {
    return oklab(linearColourAt(palette, position)).lightness;
}

const Palette& found(const char* name) {
    const Palette* palette = findInLibrary(name);
    if (palette == nullptr) qFatal("%s is not in the library", name);
    return *palette;
}

} // namespace

class TestPaletteLibrary : public QObject {
    Q_OBJECT

private slots:
    void palettesAreWellFormed() {
        std::set<std::string> names;
        for (const Palette& palette : builtInPalettes())
            names.insert(palette.name);
        QVERIFY(paletteLibrary().size() > 200);
        for (const LibraryPalette& entry : paletteLibrary()) {
            const Palette& palette = entry.palette;
            QVERIFY2(names.insert(palette.name).second, palette.name.c_str());
            QVERIFY2(palette.name.find('%') == std::string::npos, palette.name.c_str());
            QCOMPARE(entry.otherHue.empty(), entry.pattern.find("%2") == std::string_view::npos);
            QVERIFY(palette.stops.size() >= 2);
            QCOMPARE(palette.stops.front().position, 0.0);
            QCOMPARE(palette.stops.back().position, 1.0);
            for (std::size_t i = 1; i < palette.stops.size(); ++i)
                QVERIFY(palette.stops[i - 1].position <= palette.stops[i].position);
            for (const Palette::Stop& stop : palette.stops)
                QCOMPARE(int(stop.colour.alpha), 255);
        }
    }

    void palettesAreFoundWithoutCase() {
        QCOMPARE(findInLibrary("crimson GLOW"), &found("Crimson Glow"));
        QVERIFY(findInLibrary("Crimson") == nullptr);
        QVERIFY(findInLibrary("Maple") == nullptr); // a built-in one
    }

    // Equal steps of tone look equal: the densities of a picture are told by lightness alone.
    void rampsBrightenEvenly() {
        int ramps = 0;
        for (const LibraryPalette& entry : paletteLibrary()) {
            const bool darkens = entry.pattern == "%1 Ink";
            if (!darkens && entry.pattern != "%1 Glow" && entry.pattern != "%1 to %2" &&
                entry.pattern != "%1 into %2" && entry.pattern != "%1 Spectrum" &&
                entry.pattern != "%1 Pastel")
                continue;
            ++ramps;
            const double whole = lightness(entry.palette, 1) - lightness(entry.palette, 0);
            QVERIFY2(darkens ? whole < -0.4 : whole > 0.2, entry.palette.name.c_str());
            constexpr int steps = 16;
            for (int k = 0; k < steps; ++k) {
                const double step = lightness(entry.palette, double(k + 1) / steps) -
                                    lightness(entry.palette, double(k) / steps);
                const double share = step / whole * steps;
                QVERIFY2(share > 0.8 && share < 1.2, entry.palette.name.c_str());
            }
        }
        QCOMPARE(ramps, 144);
    }

    // So that colours by address go around without a seam.
    void wheelsAndTwilightsClose() {
        for (const LibraryPalette& entry : paletteLibrary()) {
            if (entry.pattern != "%1 Wheel" && entry.pattern != "%1 Twilight") continue;
            const Rgba first = entry.palette.stops.front().colour;
            const Rgba last = entry.palette.stops.back().colour;
            const Oklab a = oklab(linearColour(first));
            const Oklab b = oklab(linearColour(last));
            QVERIFY2(std::hypot(a.lightness - b.lightness, a.a - b.a, a.b - b.b) < 0.06,
                     entry.palette.name.c_str());
        }
    }

    void aDivergingPaletteIsPaleInTheMiddle() {
        const Palette& palette = found("Rose and Teal");
        QVERIFY(lightness(palette, 0.5) > 0.95);
        QVERIFY(lightness(palette, 0) < 0.42 && lightness(palette, 1) < 0.42);
    }
};

BARYCAGE_TEST(TestPaletteLibrary, QCoreApplication);
#include "palette_library_test.moc"
