// SPDX-License-Identifier: MIT
#include "attractor/colour/palette_edits.h"

#include "attractor/colour/oklab.h"
#include "attractor/colour/srgb_transfer.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>

using namespace attractor;

namespace {

Palette palette() {
    return {"", {{0, {0, 0, 0}}, {0.25, {255, 0, 0}}, {0.5, {0, 255, 0}}, {1, {255, 255, 255}}}};
}

} // namespace

class TestPaletteEdits : public QObject {
    Q_OBJECT

private slots:
    // A new stop changes no colour of the gradient, but for the rounding of its own.
    void aNewStopChangesNothing() {
        for (const double position : {-1.0, 0.0, 0.1, 0.25, 0.6, 1.0, 2.0}) {
            const Palette before = palette();
            Palette after = before;
            const std::size_t stop = addStop(after, position);
            QCOMPARE(after.stops.size(), before.stops.size() + 1);
            QVERIFY(stop > 0 && stop + 1 < after.stops.size());
            QCOMPARE(after.stops[stop].position, std::clamp(position, 0.0, 1.0));
            for (std::size_t k = 0; k + 1 < after.stops.size(); ++k)
                QVERIFY(after.stops[k].position <= after.stops[k + 1].position);
            for (double x = 0; x < 1; x += 0.01) {
                const Rgba a = colourAt(before, x);
                const Rgba b = colourAt(after, x);
                QVERIFY(std::abs(linearLight(a.red) - linearLight(b.red)) < 0.01);
                QVERIFY(std::abs(linearLight(a.green) - linearLight(b.green)) < 0.01);
            }
        }
    }

    void stopsMoveUpToTheirNeighbours() {
        Palette p = palette();
        moveStop(p, 1, 0.4);
        QCOMPARE(p.stops[1].position, 0.4);
        moveStop(p, 1, 0.9);
        QCOMPARE(p.stops[1].position, 0.5);
        moveStop(p, 1, -3);
        QCOMPARE(p.stops[1].position, 0.0);
    }

    void theEndsStay() {
        for (const std::size_t end : {std::size_t{0}, std::size_t{3}}) {
            Palette p = palette();
            QVERIFY(!canMove(p, end));
            moveStop(p, end, 0.5);
            removeStop(p, end);
            QCOMPARE(p, palette());
        }
        Palette p = palette();
        QVERIFY(canMove(p, 1));
        removeStop(p, 1);
        QCOMPARE(p.stops.size(), std::size_t{3});
        QCOMPARE(p.stops[1].colour, (Rgba{0, 255, 0}));
    }

    void reversedTwiceIsTheSame() {
        Palette p = palette();
        reverse(p);
        QCOMPARE(p.stops.front().colour, (Rgba{255, 255, 255}));
        QCOMPARE(p.stops[2].position, 0.75);
        QCOMPARE(p.stops[2].colour, (Rgba{255, 0, 0}));
        reverse(p);
        QCOMPARE(p, palette());
    }

    void distributedStopsAreEquallyFar() {
        Palette p = palette();
        distribute(p);
        for (std::size_t k = 0; k < 4; ++k)
            QCOMPARE(p.stops[k].position, static_cast<double>(k) / 3);
    }

    void aShiftGoesAround_data() {
        QTest::addColumn<double>("offset");
        for (const double offset : {0.1, 0.25, 0.4, 0.75, 1.3, -0.2})
            QTest::addRow("by %g", offset) << offset;
    }

    void aShiftGoesAround() {
        QFETCH(const double, offset);
        Palette p = palette();
        shift(p, offset);
        QCOMPARE(p.stops.front().position, 0.0);
        QCOMPARE(p.stops.back().position, 1.0);
        for (std::size_t k = 0; k + 1 < p.stops.size(); ++k)
            QVERIFY(p.stops[k].position <= p.stops[k + 1].position);
        for (double x = 0.005; x < 1; x += 0.01) {
            const double from = x + offset - std::floor(x + offset);
            const Rgba a = colourAt(p, x);
            const Rgba b = colourAt(palette(), from);
            QVERIFY(std::abs(linearLight(a.red) - linearLight(b.red)) < 0.01);
            QVERIFY(std::abs(linearLight(a.green) - linearLight(b.green)) < 0.01);
        }
    }

    void aWholeShiftChangesNothing() {
        for (const double offset : {0.0, 1.0, -3.0}) {
            Palette p = palette();
            shift(p, offset);
            QCOMPARE(p, palette());
        }
    }

    // Lightness stays, and what the screen shows of the chroma.
    void huesTurn() {
        const Palette before{"", {{0, {120, 60, 60}}, {1, {60, 60, 130}}}};
        for (const double degrees : {-180.0, -30.0, 45.0, 120.0}) {
            Palette after = before;
            turnHue(after, degrees);
            for (std::size_t k = 0; k < 2; ++k) {
                const Oklab a = oklab(linearColour(before.stops[k].colour));
                const Oklab b = oklab(linearColour(after.stops[k].colour));
                QVERIFY(std::abs(a.lightness - b.lightness) < 0.005);
                const double turned = (std::atan2(b.b, b.a) - std::atan2(a.b, a.a)) * 180 / M_PI;
                QVERIFY(std::abs(std::remainder(turned - degrees, 360.0)) < 4);
            }
        }
        Palette same = before;
        turnHue(same, 360);
        QCOMPARE(same, before);
        turnHue(same, 0);
        QCOMPARE(same, before);
    }
};

BARYCAGE_TEST(TestPaletteEdits);
#include "palette_edits_test.moc"
