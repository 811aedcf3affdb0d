// SPDX-License-Identifier: MIT
#include "attractor/tops/deferred_theft.h"

#include "../../ifs/tops/top_systems.h"
#include "attractor/colour/srgb_transfer.h"
#include "attractor/kernels/kernels.h"
#include "attractor/tops/picture_patterns.h"
#include "ifs/system/iterated_function_system.h"
#include "support/named_test.h"

#include <QTest>

using attractor::CoupledSystem;
using tops::Maps;
using tops::square;

namespace {

CoupledSystem coupledSystem(const Maps& from, const Maps& to) {
    return {tops::attractorOf(from), tops::attractorOf(to), ifs::determinantWeights<2>(from)};
}

attractor::TheftRequest requested() {
    attractor::TheftRequest request;
    request.camera = {{.5, .5}, 90, 100, 100, attractor::YAxis::Up};
    request.toPicture = ifs::affineMap(64, 0, 0, -64, 0, 64);
    request.points = 500'000;
    return request;
}

using Pixels = std::vector<std::uint32_t>;

Pixels drawn(attractor::DeferredTheft& theft, const CoupledSystem& system,
             const attractor::MipPicture& picture, const attractor::TheftRequest& request) {
    Pixels pixels(100 * 100);
    return theft.draw(system, picture, request, pixels, {}) ? pixels : Pixels();
}

Pixels stolenPixels(const CoupledSystem& system, const attractor::MipPicture& picture,
                    const attractor::TheftRequest& request) {
    Pixels result;
    attractor::steal(system, picture, request,
                     [&](std::span<const std::uint32_t> rows) {
                         result.insert(result.end(), rows.begin(), rows.end());
                         return true;
                     },
                     {});
    return result;
}

} // namespace

// Pictures that keep the keys of the one before.
class DeferredTheftTest : public QObject {
    Q_OBJECT

private slots:
    void drawsWhatStealDraws() {
        const auto picture = attractor::picture(attractor::Pattern::Grid, 64);
        attractor::TheftRequest request = requested();
        for (const int threads : {1, 3}) {
            attractor::DeferredTheft theft(threads);
            for (const Maps& to : {square(.5, .5), square(.3, .6), tops::triangle(.65, .3, .4)}) {
                const CoupledSystem system = coupledSystem(square(.5, .5), to);
                QVERIFY(drawn(theft, system, picture, request) == stolenPixels(system, picture, request));
            }
        }
    }

    // Against doubles: the colour of the picture where the top of the pixel is taken to.
    void coloursAreThoseOfThePicture() {
        const auto picture = attractor::picture(attractor::Pattern::Wheel, 64);
        attractor::TheftRequest request = requested();
        const CoupledSystem system = coupledSystem(square(.5, .5), square(.3, .6));
        std::vector<attractor::TopPoint> points(100 * 100);
        QVERIFY(
            attractor::KeyTops(system, request.camera, request.points, request.seed, {}).draw(0, points, {}));
        attractor::DeferredTheft theft(1);
        const Pixels pixels = drawn(theft, system, picture, request);
        int filled = 0;
        for (std::size_t k = 0; k < points.size(); ++k) {
            if (points[k].isEmpty()) continue;
            const ifs::Vector<2> at = request.toPicture({points[k].x, points[k].y});
            const auto seen =
                picture.at(at.x(), at.y(), points[k].stretch * attractor::picturePixels(request));
            if (seen.alpha < 1) continue; // outside
            ++filled;
            const auto differs = [&](int shift, double light) {
                return std::abs(int(pixels[k] >> shift & 255) - int(attractor::encoded(light))) > 1;
            };
            QVERIFY(!differs(16, seen.red) && !differs(8, seen.green) && !differs(0, seen.blue));
        }
        QVERIFY(filled > 5000);
    }

    void everyPictureIsTheSame() {
        const auto picture = attractor::picture(attractor::Pattern::Glass, 128);
        const CoupledSystem system = coupledSystem(square(.5, .5), square(.3, .6));
        const std::string chosen = attractor::simdName();
        Pixels expected;
        for (const std::string& set : attractor::simdNames())
            for (const int threads : {1, 2, 7}) {
                QVERIFY(attractor::selectSimd(set));
                attractor::DeferredTheft theft(threads);
                drawn(theft, coupledSystem(square(.5, .5), square(.7, .2)), picture, requested());
                const Pixels pixels = drawn(theft, system, picture, requested());
                QVERIFY(theft.hasKeptKeys());
                if (expected.empty()) expected = pixels;
                QVERIFY2(pixels == expected, set.c_str());
            }
        QVERIFY(attractor::selectSimd(chosen));
    }

    void keepsKeysWhileOnlyThePartnerOrThePictureMoves() {
        attractor::DeferredTheft theft(2);
        attractor::TheftRequest request = requested();
        const auto grid = attractor::picture(attractor::Pattern::Grid, 64);
        const auto wheel = attractor::picture(attractor::Pattern::Wheel, 64);
        const Maps from = square(.5, .5);
        const Pixels first = drawn(theft, coupledSystem(from, from), grid, request);
        QVERIFY(!theft.hasKeptKeys());
        QVERIFY(drawn(theft, coupledSystem(from, square(.4, .7)), grid, request) != first);
        QVERIFY(theft.hasKeptKeys());
        QVERIFY(drawn(theft, coupledSystem(from, from), wheel, request) != first);
        QVERIFY(theft.hasKeptKeys());
        drawn(theft, coupledSystem(square(.6, .5), from), grid, request);
        QVERIFY(!theft.hasKeptKeys());
        request.camera.centre.x() += .1;
        drawn(theft, coupledSystem(square(.6, .5), from), grid, request);
        QVERIFY(!theft.hasKeptKeys());
    }

    void keysOfAStoppedPictureAreNotKept() {
        attractor::DeferredTheft theft(2);
        const auto grid = attractor::picture(attractor::Pattern::Grid, 64);
        const CoupledSystem system = coupledSystem(square(.5, .5), square(.5, .5));
        std::stop_source stop;
        stop.request_stop();
        Pixels pixels(100 * 100);
        QVERIFY(!theft.draw(system, grid, requested(), pixels, stop.get_token()));
        drawn(theft, system, grid, requested());
        QVERIFY(!theft.hasKeptKeys());
    }

    // What is drawn stays, and empty pixels show the picture there.
    void thePictureLiesUnderWhatIsEmpty() {
        const auto picture = attractor::picture(attractor::Pattern::Wheel, 64);
        attractor::TheftRequest request = requested();
        request.background = {0, 0, 0, 255};
        Pixels pixels(100 * 100, 0);
        pixels[5050] = 0xFF123456;
        attractor::DeferredTheft(2).layUnder(pixels, picture, request, .5);
        QCOMPARE(pixels[5050], 0xFF123456U);
        QVERIFY(std::ranges::all_of(pixels, [](std::uint32_t pixel) { return pixel >> 24 == 255; }));
        QCOMPARE(pixels[0], 0xFF000000U);           // outside of the picture
        QVERIFY((pixels[5060] & 0xFFFFFF) != 0);    // in its middle
        QVERIFY((pixels[5060] >> 16 & 255) <= 128); // half as strong
    }

    void patternsAreNamedAndDiffer() {
        std::vector<double> middles;
        for (const attractor::Pattern pattern : attractor::patterns) {
            QCOMPARE(ifs::named<attractor::Pattern>(ifs::nameOf(pattern)), std::optional(pattern));
            const auto picture = attractor::picture(pattern, 32);
            QCOMPARE(picture.width(), 32);
            middles.push_back(picture.at(16, 16, 1024).red);
        }
        std::ranges::sort(middles);
        QVERIFY(std::ranges::adjacent_find(middles) == middles.end());
        QVERIFY(!ifs::named<attractor::Pattern>("no such"));
    }
};

BARYCAGE_TEST(DeferredTheftTest);
#include "deferred_theft_test.moc"
