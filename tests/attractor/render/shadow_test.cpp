// SPDX-License-Identifier: MIT
#include "attractor/request/shadow.h"

#include "attractor/render/banded_rendering.h"
#include "attractor/render/renderer.h"
#include "attractor/systems.h"
#include "support/named_test.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <span>
#include <stop_token>
#include <vector>

using namespace attractor;
using ifs::Vector;

namespace {

constexpr int shadowColumns = 320, shadowRows = 200;

// Its shadow falls to the right, where the view has room for it.
RenderRequest shadowed(const ifs::IteratedFunctionSystem<2>& system, std::uint64_t samples = 2'000'000) {
    RenderRequest request = systems::request(system, samples);
    request.camera.pixelsPerUnit *= 0.6;
    request.camera.centre.x() += 0.25 * shadowColumns / request.camera.pixelsPerUnit;
    request.appearance.shadow = 0.8;
    request.appearance.shadowLean = 1.2;
    request.appearance.shadowLength = 0.5;
    const PreparedSystem prepared = attractor::prepared(system);
    request.shadow = shadowMap(request.appearance, (prepared.centre - prepared.halfExtent).y(), YAxis::Up);
    return request;
}

ifs::ControlCage<2> foldedCage() {
    return {{{-4, -4}, {4, -4}, {4, 6}, {-4, 6}}, {{-4, -4}, {3, -3}, {4, 6}, {-1, 3}}};
}

std::uint32_t pixelAt(const std::vector<std::uint32_t>& pixels, int x, int y) {
    return pixels[std::size_t(y) * shadowColumns + std::size_t(x)];
}

bool isLitNear(const Vector<2>& pixel, const std::vector<std::uint32_t>& pixels, std::uint32_t nothing,
               int reach) {
    for (int y = int(pixel.y()) - reach; y <= int(pixel.y()) + reach; ++y)
        for (int x = int(pixel.x()) - reach; x <= int(pixel.x()) + reach; ++x)
            if (x >= 0 && y >= 0 && x < shadowColumns && y < shadowRows && pixelAt(pixels, x, y) != nothing)
                return true;
    return false;
}

int brightest(std::uint32_t pixel) {
    return int(std::max({pixel >> 16 & 0xFFU, pixel >> 8 & 0xFFU, pixel & 0xFFU}));
}

} // namespace

class ShadowTest : public QObject {
    Q_OBJECT

private slots:
    void theGroundStaysAndHeightsFall() {
        Appearance appearance;
        appearance.shadowLean = 0.75;
        appearance.shadowLength = 0.25;
        const ifs::AffineMap<2> up = shadowMap(appearance, -2, YAxis::Up);
        QCOMPARE(up(Vector<2>(3, -2)), Vector<2>(3, -2));
        QCOMPARE(up(Vector<2>(3, 2)), Vector<2>(6, -1));
        const ifs::AffineMap<2> down = shadowMap(appearance, 2, YAxis::Down);
        QCOMPARE(down(Vector<2>(3, 2)), Vector<2>(3, 2));
        QCOMPARE(down(Vector<2>(3, -2)), Vector<2>(6, 1));
    }

    void aPictureWithoutAShadowKeepsItsBytes() {
        const RenderRequest plain = systems::request(systems::maple(), 1'000'000);
        const Frame frame = render(plain);
        RenderRequest unseen = plain;
        unseen.shadow = shadowMap(plain.appearance, -1, YAxis::Up);
        QVERIFY(render(unseen).pixels == frame.pixels);
        RenderRequest groundless = plain;
        groundless.appearance.shadow = 0.5;
        QVERIFY(render(groundless).pixels == frame.pixels);
        QVERIFY(!shadowRequest(unseen) && !shadowRequest(groundless));
    }

    // Every pixel of the shadow is where the map takes a pixel of the picture, and the other way round, also
    // under a cage that bends.
    void theShadowIsTheImageOfThePicture_data() {
        QTest::addColumn<bool>("bends");
        QTest::newRow("affine") << false;
        QTest::newRow("bent") << true;
    }
    void theShadowIsTheImageOfThePicture() {
        QFETCH(const bool, bends);
        RenderRequest request = shadowed(systems::maple());
        if (bends) request.cage = foldedCage();
        const auto shadow = shadowRequest(request);
        QVERIFY(shadow);
        const RenderRequest alone = requestAboveShadow(request);
        const std::vector<std::uint32_t> picture = render(alone).pixels, fallen = render(*shadow).pixels;
        const ifs::AffineMap<2> back = ifs::inverse<2>(*request.shadow).value();
        int lit = 0, wrong = 0;
        for (int y = 0; y < shadowRows; ++y)
            for (int x = 0; x < shadowColumns; ++x) {
                const Vector<2> world = toWorld(request.camera, Vector<2>(x + 0.5, y + 0.5));
                if (pixelAt(fallen, x, y) != 0) {
                    ++lit;
                    const Vector<2> from = toPixel(request.camera, back(world));
                    if (from.x() >= 0 && from.x() < shadowColumns && from.y() >= 0 && from.y() < shadowRows)
                        wrong += !isLitNear(from, picture, 0, 2);
                }
                if (pixelAt(picture, x, y) != 0) {
                    const Vector<2> to = toPixel(request.camera, (*request.shadow)(world));
                    if (to.x() >= 2 && to.x() < shadowColumns - 2 && to.y() >= 2 && to.y() < shadowRows - 2)
                        wrong += !isLitNear(to, fallen, 0, 2);
                }
            }
        QVERIFY2(lit > 1000, qPrintable(QString::number(lit)));
        QVERIFY2(wrong < lit / 100, qPrintable(QString::number(wrong)));
    }

    // Darker than the picture on a dark ground, and seen on a light one.
    void theShadowIsDarkerThanThePicture() {
        for (const bool isOnPaper : {false, true}) {
            RenderRequest request = shadowed(systems::maple());
            request.appearance.colourBy = ColourBy::Plain;
            if (isOnPaper) request.appearance.background = {255, 255, 255, 255};
            const std::vector<std::uint32_t> whole = render(request).pixels;
            const std::vector<std::uint32_t> picture = render(requestAboveShadow(request)).pixels;
            const std::vector<std::uint32_t> shadow = render(*shadowRequest(request)).pixels;
            const std::uint32_t ground = whole.front();
            int seen = 0, brightestOfPicture = 0, brightestOfShadow = 0;
            for (std::size_t i = 0; i < whole.size(); ++i) {
                if (picture[i] != 0) brightestOfPicture = std::max(brightestOfPicture, brightest(whole[i]));
                if (picture[i] != 0 || shadow[i] == 0) continue;
                seen += whole[i] != ground;
                brightestOfShadow = std::max(brightestOfShadow, brightest(whole[i]));
                if (isOnPaper) QVERIFY(brightest(whole[i]) <= 255);
            }
            QVERIFY2(seen > 1000, qPrintable(QString::number(seen)));
            if (!isOnPaper) QVERIFY(brightestOfShadow > 50 && brightestOfShadow < brightestOfPicture / 2);
            QCOMPARE(whole.front(), ground);
        }
    }

    void thePictureIsInFrontOfItsShadow() {
        RenderRequest request = shadowed(systems::tiling(2, 2));
        request.appearance.colourBy = ColourBy::Plain;
        request.appearance.plain = {255, 0, 0, 255};
        request.appearance.shadowLean = 0.2;
        request.shadow = shadowMap(request.appearance, 0, YAxis::Up);
        const std::vector<std::uint32_t> whole = render(request).pixels;
        const std::vector<std::uint32_t> picture = render(requestAboveShadow(request)).pixels;
        const std::vector<std::uint32_t> shadow = render(*shadowRequest(request)).pixels;
        int covered = 0;
        for (std::size_t i = 0; i < whole.size(); ++i) {
            const int alpha = int(picture[i] >> 24), red = int(picture[i] >> 16 & 0xFFU);
            if (alpha < 128 || shadow[i] == 0) continue;
            ++covered;
            QVERIFY(brightest(whole[i]) >= red && brightest(whole[i]) <= red + 102 * (255 - alpha) / 255 + 1);
        }
        QVERIFY(covered > 500);
    }

    void theOpacityFadesFromNothing() {
        RenderRequest request = shadowed(systems::maple());
        const std::vector<std::uint32_t> none = [&] {
            RenderRequest plain = request;
            plain.appearance.shadow = 0;
            return render(plain).pixels;
        }();
        const auto distance = [&](double opacity) {
            request.appearance.shadow = opacity;
            const std::vector<std::uint32_t> pixels = render(request).pixels;
            double sum = 0;
            for (std::size_t i = 0; i < pixels.size(); ++i)
                sum += std::abs(brightest(pixels[i]) - brightest(none[i]));
            return sum;
        };
        const double faint = distance(1e-4), half = distance(0.5), full = distance(1);
        QVERIFY2(faint < full / 50, qPrintable(QString::number(faint / full)));
        QVERIFY(half > full / 3 && half < full);
    }

    void bandsShowNoSeams() {
        for (const bool bends : {false, true}) {
            RenderRequest request = shadowed(systems::maple());
            if (bends) request.cage = foldedCage();
            bandsAreThePicture<std::uint32_t>(request);
            bandsAreThePicture<Rgba16>(request);
        }
    }

    // Looking at the shadow alone, there is no picture in view.
    void theShadowIsSeenWithoutThePicture() {
        RenderRequest request = shadowed(systems::maple());
        const PreparedSystem system = prepared(request.system);
        const Vector<2> top = system.centre + Vector<2>(0, 0.7 * system.halfExtent.y());
        request.camera.centre = (*request.shadow)(top);
        request.camera.pixelsPerUnit *= 20;
        const std::vector<std::uint32_t> picture = render(requestAboveShadow(request)).pixels;
        QVERIFY(std::ranges::all_of(picture, [](std::uint32_t pixel) { return pixel == 0; }));
        const std::vector<std::uint32_t> whole = render(request).pixels;
        QVERIFY(std::ranges::any_of(whole, [&](std::uint32_t pixel) { return pixel != whole.front(); }));
    }

    void aStopIsMadeUpFor() {
        const RenderRequest request = shadowed(systems::maple());
        const Frame whole = render(request);
        std::stop_source stopped;
        stopped.request_stop();
        Rendering interrupted(request);
        QVERIFY(!interrupted.refine(stopped.get_token()));
        QVERIFY(interrupted.frame().pixels == whole.pixels);
    }

    void threadsChangeNothing() {
        RenderRequest request = shadowed(systems::maple());
        const Frame one = render(request);
        request.threads = 3;
        QVERIFY(render(request).pixels == one.pixels);
    }

    // A moment of a shutter has its own shadow.
    void aShutterMovesTheShadow() {
        const RenderRequest request = shadowed(systems::maple());
        RenderRequest later = request;
        later.appearance.shadowLean = 0.2;
        later.shadow = shadowMap(later.appearance, -2, YAxis::Up);
        const auto drawn = [&](const std::vector<RenderRequest>& moments) {
            BandedRendering rendering(request);
            if (!moments.empty()) rendering.openShutter(moments);
            std::vector<std::uint32_t> pixels(std::size_t(shadowColumns) * shadowRows);
            return rendering.band(0, shadowRows, std::span(pixels)) ? pixels : std::vector<std::uint32_t>{};
        };
        const auto still = drawn({request, request}), moved = drawn({request, later});
        QVERIFY(!still.empty() && still.size() == moved.size());
        QVERIFY(still != moved);
    }

private:
    template <class Pixel> static void bandsAreThePicture(const RenderRequest& request) {
        BandedRendering banded(request);
        std::vector<Pixel> whole(std::size_t(shadowColumns) * shadowRows);
        QVERIFY(banded.band(0, shadowRows, std::span(whole)));
        std::vector<Pixel> joined(whole.size());
        BandedRendering again(request);
        for (const auto& [first, rows] : {std::pair(130, 70), std::pair(0, 77), std::pair(77, 53)})
            QVERIFY(again.band(first, rows,
                               std::span(joined).subspan(std::size_t(first) * shadowColumns,
                                                         std::size_t(rows) * shadowColumns)));
        QVERIFY(joined == whole);
        RenderRequest unshadowed = request;
        unshadowed.appearance.shadow = 0;
        BandedRendering plain(unshadowed);
        std::vector<Pixel> without(whole.size());
        QVERIFY(plain.band(0, shadowRows, std::span(without)));
        QVERIFY(without != whole);
    }
};

BARYCAGE_TEST(ShadowTest);
#include "shadow_test.moc"
