// SPDX-License-Identifier: MIT
#include "attractor/render/banded_rendering.h"

#include "attractor/light/tone_map.h"
#include "attractor/render/renderer.h"
#include "attractor/systems.h"
#include "support/named_test.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <set>

using namespace attractor;

namespace {

template <class Pixel> void bandsAreThePicture(const RenderRequest& request) {
    BandedRendering banded(request);
    std::vector<Pixel> whole(320 * 200);
    QVERIFY(banded.band(0, 200, std::span(whole)));
    QVERIFY(std::any_of(whole.begin(), whole.end(),
                        [&](const Pixel& pixel) { return !(pixel == whole.front()); }));
    std::vector<Pixel> joined(whole.size());
    BandedRendering again(request);
    for (const auto& [first, rows] : {std::pair(130, 70), std::pair(0, 77), std::pair(77, 53)})
        QVERIFY(again.band(first, rows,
                           std::span(joined).subspan(std::size_t(first) * 320, std::size_t(rows) * 320)));
    QVERIFY(joined == whole);
}

} // namespace

class BandedRenderingTest : public QObject {
    Q_OBJECT

private slots:
    // Threads and bands change nothing, and what stands still is as bright as without a shutter.
    void aShutterAddsUpMoments() {
        RenderRequest request = systems::request(systems::maple(), 2'000'000);
        RenderRequest right = request;
        right.camera.centre.x() -= 20 / request.camera.pixelsPerUnit;
        const auto drawn = [&](const std::vector<RenderRequest>& moments, int threads,
                               const std::vector<std::pair<int, int>>& bands) {
            RenderRequest whole = request;
            whole.threads = threads;
            BandedRendering rendering(whole);
            rendering.openShutter(moments);
            std::vector<std::uint32_t> pixels(320 * 200);
            for (const auto& [first, rows] : bands)
                if (!rendering.band(
                        first, rows,
                        std::span(pixels).subspan(std::size_t(first) * 320, std::size_t(rows) * 320)))
                    pixels.clear();
            return pixels;
        };
        const auto blurred = drawn({request, right}, 1, {{0, 200}});
        QVERIFY(drawn({request, right}, 3, {{100, 100}, {0, 100}}) == blurred);
        const auto still = drawn({request, request, request}, 1, {{0, 200}}),
                   single = drawn({}, 1, {{0, 200}});
        const std::uint32_t background = single.front();
        int lit = 0, litStill = 0, outside = 0, missing = 0;
        for (int y = 0; y < 200; ++y)
            for (int x = 20; x < 320; ++x) {
                const auto at = std::size_t(y) * 320 + std::size_t(x);
                const bool isLeft = single[at] != background, isRight = single[at - 20] != background;
                lit += isLeft;
                litStill += still[at] != background;
                outside += blurred[at] != background && !isLeft && !isRight;
                missing += blurred[at] == background && isLeft && isRight;
            }
        QVERIFY(lit > 5000);
        QVERIFY(std::abs(litStill - lit) < lit / 20);
        QVERIFY(outside < lit / 20 && missing < lit / 20);
    }

    void anExposureCanBeSet() {
        const RenderRequest request = systems::request(systems::maple(), 1'000'000);
        BandedRendering measured(request), set(request);
        const auto exposure = measured.measuredExposure();
        QVERIFY(exposure && exposure->meanDensity > 0);
        std::vector<std::uint32_t> own(320 * 200), same(own), bright(own);
        QVERIFY(measured.band(0, 200, std::span(own)));
        QVERIFY(measured.exposure() == *exposure);
        set.useExposure(*exposure);
        QVERIFY(set.band(0, 200, std::span(same)));
        QVERIFY(same == own);
        BandedRendering brighter(request);
        brighter.useExposure({exposure->meanDensity / 4, exposure->whitePoint, exposure->gain});
        QVERIFY(brighter.band(0, 200, std::span(bright)));
        QVERIFY(bright != own);
    }

    void bandsShowNoSeams_data() {
        QTest::addColumn<int>("side");
        QTest::addColumn<int>("colourBy");
        QTest::addColumn<int>("algorithm");
        const auto add = [](const char* name, int side, ColourBy colourBy, Algorithm algorithm) {
            QTest::newRow(name) << side << int(colourBy) << int(algorithm);
        };
        add("density", 1, ColourBy::Density, Algorithm::Density);
        add("supersampled", 2, ColourBy::Plain, Algorithm::Density);
        add("by map", 1, ColourBy::Map, Algorithm::Density);
        add("by address, supersampled", 2, ColourBy::Address, Algorithm::Density);
        add("chaos game", 1, ColourBy::Density, Algorithm::ChaosGame);
        add("deterministic", 2, ColourBy::Map, Algorithm::Deterministic);
        add("bent", 1, ColourBy::Density, Algorithm::Density);
        add("bent, by map", 2, ColourBy::Map, Algorithm::Density);
    }

    void bandsShowNoSeams() {
        QFETCH(const int, side);
        QFETCH(const int, colourBy);
        QFETCH(const int, algorithm);
        RenderRequest request = systems::request(systems::maple(), 2'000'000);
        request.appearance.supersample = side;
        request.appearance.colourBy = ColourBy(colourBy);
        request.algorithm = Algorithm(algorithm);
        request.iterations = 5;
        if (QByteArray(QTest::currentDataTag()).startsWith("bent"))
            request.cage = ifs::ControlCage<2>{{{-4, -4}, {4, -4}, {4, 6}, {-4, 6}},
                                               {{-4, -4}, {3, -3}, {4, 6}, {-1, 3}}};
        bandsAreThePicture<std::uint32_t>(request);
        bandsAreThePicture<Rgba16>(request);
    }

    void bandsLookLikeTheWholePicture() {
        for (const auto algorithm : {Algorithm::Density, Algorithm::ChaosGame}) {
            RenderRequest request = systems::request(systems::maple(), 2'000'000);
            request.algorithm = algorithm;
            Frame banded;
            banded.pixels.resize(320 * 200);
            QVERIFY(BandedRendering(request).band(0, 200, banded.pixels));
            QVERIFY(std::abs(systems::meanGrey(banded) / systems::meanGrey(render(request)) - 1) < 0.03);
        }
    }

    void sixteenBitsAreThePictureInFinerSteps() {
        for (const int side : {1, 2})
            for (const ColourBy colourBy : {ColourBy::Density, ColourBy::Plain, ColourBy::Map}) {
                RenderRequest request = systems::request(systems::maple(), 3'000'000);
                request.appearance.supersample = side;
                request.appearance.colourBy = colourBy;
                request.appearance.background = {10, 20, 30, 255};
                BandedRendering banded(request);
                std::vector<std::uint32_t> coarse(320 * 200);
                std::vector<Rgba16> fine(coarse.size());
                QVERIFY(banded.band(0, 200, coarse));
                QVERIFY(banded.band(0, 200, fine));
                std::set<std::uint16_t> shades;
                int between = 0; // what doubling 8 bits cannot give
                for (std::size_t i = 0; i < fine.size(); ++i) {
                    const auto near = [](std::uint16_t deep, std::uint32_t pixel, int shift) {
                        return std::abs(deep / 257.0 - double(pixel >> shift & 255U)) < 2.5;
                    };
                    QVERIFY(near(fine[i].red, coarse[i], 16) && near(fine[i].green, coarse[i], 8) &&
                            near(fine[i].blue, coarse[i], 0));
                    QCOMPARE(fine[i].alpha, std::uint16_t{65535});
                    shades.insert(fine[i].green);
                    between += fine[i].green % 257 != 0 ? 1 : 0;
                }
                QVERIFY2(shades.size() > 600, qPrintable(QString::number(shades.size())));
                QVERIFY(between > 1000);
            }
    }

    void sixteenBitTonesAreExact() {
        RenderRequest request = systems::request(systems::sierpinski(), 400'000);
        request.appearance.background.alpha = 0;
        BandedRendering banded(request);
        std::vector<Rgba16> pixels(320 * 200);
        QVERIFY(banded.band(0, 200, pixels));
        const Exposure exposure = banded.exposure();
        // Opacity is the tone of a whole number of samples: the first few, found among the pixels.
        std::set<std::uint16_t> opacities;
        for (const Rgba16& pixel : pixels)
            opacities.insert(pixel.alpha);
        for (int samples = 1; samples <= 12; ++samples) {
            const double density = samples / (400'000 * exposure.meanDensity);
            const double v =
                tone(density, request.appearance.brightness, exposure.whitePoint, request.appearance.gamma);
            QVERIFY(opacities.contains(static_cast<std::uint16_t>(v * 65535 + 0.5)));
        }
    }

    void aHugePictureNeedsTheMemoryOfABand() {
        const RenderRequest request = systems::request(systems::sierpinski(), 1'000'000, 30'000, 30'000);
        QVERIFY(BandedRendering::rowsWithin(request, 64U << 20) < 500);
        QCOMPARE(BandedRendering::rowsWithin(request, 10 * BandedRendering::bytesPerRow(request)), 10);
        QCOMPARE(BandedRendering::rowsWithin(request, 1), 1);
        BandedRendering banded(request);
        std::vector<std::uint32_t> band(std::size_t{8} * 30'000);
        double told = 0;
        QVERIFY(banded.band(20'000, 8, band, {}, [&](double fraction) {
            QVERIFY(fraction >= told && fraction <= 1);
            told = fraction;
        }));
        QCOMPARE(told, 1.0);
        QVERIFY(std::any_of(band.begin(), band.end(),
                            [](std::uint32_t pixel) { return systems::grey(pixel) > 0; }));
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(!banded.band(0, 8, band, stop.get_token()));
        QVERIFY(!BandedRendering(request).band(0, 8, band, stop.get_token()));
    }
};

BARYCAGE_TEST(BandedRenderingTest);
#include "banded_rendering_test.moc"
