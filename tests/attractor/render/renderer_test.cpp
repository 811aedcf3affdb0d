// SPDX-License-Identifier: MIT
#include "attractor/render/renderer.h"

#include "attractor/kernels/kernels.h"
#include "attractor/light/tone_map.h"
#include "attractor/systems.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>
#include <limits>
#include <random>

using namespace attractor;

namespace {

std::vector<int> greys(const Frame& frame) {
    std::vector<int> result;
    for (const std::uint32_t pixel : frame.pixels)
        result.push_back(systems::grey(pixel));
    return result;
}

double psnr(const std::vector<int>& a, const std::vector<int>& b) {
    double squares = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double difference = a[i] - b[i];
        squares += difference * difference;
    }
    return 10 * std::log10(255.0 * 255.0 * static_cast<double>(a.size()) / squares);
}

// A chaos game that shares nothing with the engine, shown with the tones of `like`.
std::vector<int> independentPicture(const RenderRequest& request, const Frame& like, int points,
                                    std::uint64_t seed = 2024) {
    std::mt19937_64 random(seed);
    const std::vector<double> p = ifs::probabilities(request.system);
    std::discrete_distribution<std::size_t> choice(p.begin(), p.end());
    std::vector<double> counts(like.pixels.size());
    ifs::Vector<2> x = ifs::Vector<2>::Zero();
    for (int n = -1000; n < points; ++n) {
        x = request.system.maps[choice(random)].map(x);
        const ifs::Vector<2> at = toPixel(request.camera, x);
        if (n >= 0 && at.x() >= 0 && at.x() < request.camera.width && at.y() >= 0 &&
            at.y() < request.camera.height)
            counts[static_cast<std::size_t>(at.y()) * static_cast<std::size_t>(request.camera.width) +
                   static_cast<std::size_t>(at.x())] += 1;
    }
    std::vector<int> picture;
    for (const double count : counts) {
        const double density = count / points / like.exposure.meanDensity;
        const double v = std::pow(std::log1p(request.appearance.brightness * density) /
                                      std::log1p(request.appearance.brightness * like.exposure.whitePoint),
                                  1 / request.appearance.gamma);
        picture.push_back(static_cast<int>(std::lround(255 * std::min(1.0, v))));
    }
    return picture;
}

} // namespace

class TestRenderer : public QObject {
    Q_OBJECT

private slots:
    void agreesWithAnIndependentChaosGame() {
        for (const auto& system :
             {systems::maple(), systems::fern(), systems::sierpinski(), systems::dragon()}) {
            const RenderRequest request = systems::request(system, 12'000'000, 200, 150);
            const Frame frame = render(request);
            const double similarity = psnr(independentPicture(request, frame, 12'000'000), greys(frame));
            QVERIFY2(similarity > 32, qPrintable(QString::number(similarity)));
        }
    }

    void refinementConverges() {
        RenderRequest request = systems::request(systems::maple(), 200'000, 200, 150);
        Rendering rendering(request);
        rendering.refine();
        const Frame rough = rendering.frame();
        const std::vector<int> truth = independentPicture(request, rough, 20'000'000);
        for (int pass = 0; pass < 5; ++pass)
            rendering.refine({}, 2'000'000);
        const Frame fine = rendering.frame();
        QCOMPARE(fine.samples / 100'000, std::uint64_t{102});
        QCOMPARE(fine.passes, 6);
        QCOMPARE(fine.exposure, rough.exposure);
        QVERIFY(psnr(truth, greys(fine)) > psnr(truth, greys(rough)) + 8);
    }

    // Within one sample set and over several: the picture gains on the truth as a chaos game of its own
    // would.
    void refinementIsAsGoodAsIndependentPoints() {
        for (const auto& system : {systems::fern(), systems::maple()}) {
            const RenderRequest request = systems::request(system, 300'000, 480, 360);
            Rendering rendering(request);
            rendering.refine();
            const Frame first = rendering.frame();
            const std::vector<int> truth = independentPicture(request, first, 80'000'000);
            double before = 0;
            std::uint64_t samples = 0;
            for (const std::uint64_t total : {300'000, 1'200'000, 4'800'000}) {
                if (samples > 0) rendering.refine({}, total - samples);
                samples = total;
                const double ours = psnr(truth, greys(rendering.frame()));
                const double theirs = psnr(truth, independentPicture(request, first, int(total), total));
                const QString found = QStringLiteral("%1: %2 %3").arg(total).arg(ours).arg(theirs);
                QVERIFY2(ours > theirs - 1, qPrintable(found));
                QVERIFY2(ours > before + 3, qPrintable(found));
                before = ours;
            }
        }
    }

    // Moved by whole pixels, the picture is the same but for samples on the very border of a pixel.
    void grainMovesWithTheDrag() {
        for (const ColourBy colourBy : {ColourBy::Plain, ColourBy::Map}) {
            RenderRequest request = systems::request(systems::fern(), 200'000, 300, 200);
            request.appearance.colourBy = colourBy;
            request.camera.pixelsPerUnit *= 0.5; // nothing leaves the view
            request.cage = systems::squeezed(1);
            const Frame before = render(request);
            request.exposure = before.exposure;
            const int right = 17;
            const int up = 9;
            for (ifs::Vector<2>& vertex : request.cage->current)
                vertex += ifs::Vector<2>(right, up) / request.camera.pixelsPerUnit;
            const Frame after = render(request);
            int occupied = 0;
            int same = 0;
            for (int y = up; y < 200; ++y)
                for (int x = 0; x + right < 300; ++x) {
                    const std::uint32_t was = before.pixels[std::size_t(y) * 300 + std::size_t(x)];
                    if (systems::grey(was) == 0) continue;
                    ++occupied;
                    same += was == after.pixels[std::size_t(y - up) * 300 + std::size_t(x + right)];
                }
            QVERIFY(occupied > 1000);
            QVERIFY2(same > 0.98 * occupied, qPrintable(QStringLiteral("%1 of %2").arg(same).arg(occupied)));
        }
    }

    void samePixelsForAnyThreadsAndInstructionSet() {
        const std::string chosen = simdName();
        std::vector<RenderRequest> requests;
        for (const ColourBy colourBy : {ColourBy::Density, ColourBy::Map, ColourBy::Address})
            for (const auto& system : {systems::fern(), systems::tiling(5, 4), systems::tiling(9, 8)}) {
                RenderRequest request = systems::request(system, 300'000);
                request.appearance.colourBy = colourBy;
                request.appearance.supersample = colourBy == ColourBy::Map ? 2 : 1;
                requests.push_back(request);
                request.cage = systems::squeezed(0.7);
                request.cage->rest.emplace_back(1, 1); // bends
                request.cage->current.emplace_back(1.4, 0.9);
                request.algorithm = Algorithm::Density;
                requests.push_back(request);
                request.cage->current[3] = {1e3, 7}; // steeply
                requests.push_back(request);
                request.cage.reset();
                request.camera = zoomedAt(request.camera, {111, 77}, 1e4);
                requests.push_back(request);
            }
        for (const RenderRequest& request : requests) {
            const Frame reference = render(request);
            for (const int threads : {2, 3, 7}) {
                RenderRequest shared = request;
                shared.threads = threads;
                QVERIFY(render(shared).pixels == reference.pixels);
            }
            for (const char* name : {"scalar", "sse4", "avx2", "avx512"})
                if (selectSimd(name)) QVERIFY2(render(request).pixels == reference.pixels, name);
            QVERIFY(selectSimd(chosen));
            RenderRequest other = request;
            other.seed = 2;
            QVERIFY(reference.measure == 0 || render(other).pixels != reference.pixels);
        }
    }

    void restartIsAsGoodAsNew() {
        RenderRequest first = systems::request(systems::maple(), 100'000);
        RenderRequest second = systems::request(systems::fern(), 100'000, 111, 77);
        second.appearance.colourBy = ColourBy::Map;
        RenderRequest seeded = first;
        seeded.seed = 7;
        seeded.threads = 2;
        seeded.samples = 20'000'000; // two sets of samples, the first of which is no longer there
        RenderRequest moved = seeded;
        moved.camera.pixelsPerUnit *= 1.1;
        RenderRequest edited = moved;
        edited.system.maps[0].map.translation.x() += 0.1;
        edited.samples = 100'000;
        RenderRequest shown = edited; // by the same samples
        shown.camera.pixelsPerUnit *= 1.1;
        RenderRequest linked = shown;
        const ifs::MapId map = linked.system.maps[0].id;
        linked.system.links.push_back({map, map, 0});
        Rendering rendering(first);
        rendering.refine();
        for (const RenderRequest& request :
             {second, first, seeded, moved, edited, shown, linked, shown, second, first}) {
            rendering.restart(request);
            rendering.refine();
            QVERIFY(rendering.frame().pixels == render(request).pixels);
        }
    }

    void aStoppedPassIsMadeUpFor() {
        const RenderRequest request = systems::request(systems::maple(), 3'000'000);
        Rendering rendering(request);
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(!rendering.refine(stop.get_token()));
        QVERIFY(rendering.refine());
        QCOMPARE(rendering.frame().samples, std::uint64_t{6'000'000});
        Rendering undisturbed(request);
        undisturbed.refine();
        undisturbed.refine();
        QVERIFY(rendering.frame().pixels == undisturbed.frame().pixels);
    }

    // A frame that is no longer needed is abandoned before its first rows.
    void aStoppedFrameIsNotFinished() {
        for (const int side : {1, 4}) {
            RenderRequest request = systems::request(systems::maple(), 1'000'000);
            request.appearance.supersample = side;
            Rendering rendering(request);
            rendering.refine();
            std::stop_source stop;
            stop.request_stop();
            Frame untouched;
            untouched.pixels.assign(320 * 200, 0x12345678U);
            const std::vector<std::uint32_t> before = untouched.pixels;
            QVERIFY(rendering.frame(std::move(untouched), stop.get_token()).pixels == before);
            QVERIFY(rendering.frame().pixels == render(request).pixels);
        }
    }

    void transparentLaidOverTheBackgroundIsTheSame() {
        RenderRequest request = systems::request(systems::maple(), 1'000'000);
        request.appearance = Appearance{};
        const Frame opaque = render(request);
        const Rgba ground = request.appearance.background;
        request.appearance.background.alpha = 0;
        const Frame clear = render(request);
        for (std::size_t i = 0; i < clear.pixels.size(); ++i) {
            const int alpha = static_cast<int>(clear.pixels[i] >> 24);
            QCOMPARE(int(opaque.pixels[i] >> 24), 255);
            const std::array<int, 3> back{ground.blue, ground.green, ground.red};
            for (int channel = 0; channel < 3; ++channel) {
                const int front = static_cast<int>(clear.pixels[i] >> (8 * channel) & 255U);
                QVERIFY(front <= alpha); // premultiplied
                const double over = front + back[static_cast<std::size_t>(channel)] * (255 - alpha) / 255.0;
                QVERIFY(std::abs(over - static_cast<int>(opaque.pixels[i] >> (8 * channel) & 255U)) <= 1.6);
            }
        }
    }

    void mapsKeepTheirColours() {
        RenderRequest request = systems::request(systems::sierpinski(), 500'000);
        request.appearance.colourBy = ColourBy::Map;
        request.appearance.mapColours[request.system.maps[1].id] = {255, 0, 0, 255};
        request.appearance.mapColours[request.system.maps[0].id] = {0, 255, 0, 255};
        request.appearance.mapColours[request.system.maps[2].id] = {0, 0, 255, 255};
        const Frame frame = render(request);
        for (int y = 0; y < request.camera.height; ++y)
            for (int x = 0; x < request.camera.width; ++x) {
                const std::uint32_t pixel =
                    frame.pixels[static_cast<std::size_t>(y * request.camera.width + x)];
                if ((pixel & 0xffffffU) == 0) continue;
                const ifs::Vector<2> at = toWorld(request.camera, {x + 0.5, y + 0.5});
                const double margin = 2 / request.camera.pixelsPerUnit;
                if (at.x() > 0.5 + margin)
                    QCOMPARE(pixel & 0x00ffffU, 0U);
                else if (at.y() > 0.5 + margin)
                    QCOMPARE(pixel & 0xffff00U, 0U);
                else if (at.x() < 0.5 - margin && at.y() < 0.5 - margin)
                    QCOMPARE(pixel & 0xff00ffU, 0U);
            }
    }

    void paperModePlotsExactlyThePointsAsked() {
        RenderRequest request = systems::request(systems::maple(), 1000, 64, 64);
        request.algorithm = Algorithm::ChaosGame;
        Rendering rendering(request);
        QVERIFY(!rendering.finished());
        rendering.refine({}, 300);
        QCOMPARE(rendering.frame().samples, std::uint64_t{300});
        rendering.refine({}, 10'000);
        QCOMPARE(rendering.frame().samples, std::uint64_t{1000});
        QVERIFY(rendering.finished());
        QVERIFY(rendering.frame().pixels == render(request).pixels);
    }

    // W⁰ is the triangle itself, W¹ of the gasket leaves out its middle quarter.
    void deterministicAlgorithmFillsImages() {
        RenderRequest request = systems::request(systems::sierpinski(), 1, 400, 400);
        request.algorithm = Algorithm::Deterministic;
        request.cage = ifs::cageAtRest<2>({ifs::Vector<2>(0, 0), ifs::Vector<2>(1, 0), ifs::Vector<2>(0, 1)});
        double before = 0;
        for (int n = 0; n <= 4; ++n) {
            request.iterations = n;
            const Frame frame = render(request);
            double covered = 0;
            for (const std::uint32_t pixel : frame.pixels)
                covered += systems::grey(pixel) > 0 ? 1 : 0;
            covered /= request.camera.pixelsPerUnit * request.camera.pixelsPerUnit;
            QVERIFY2(std::abs(covered - 0.5 * std::pow(0.75, n)) < 0.025,
                     qPrintable(QString::number(covered)));
            QVERIFY(n == 0 || covered < before);
            QCOMPARE(frame.iterations, n);
            before = covered;
        }
        request.iterations = 2;
        const Frame copies = render(request);
        const auto brightnessAt = [&](double x, double y) {
            const ifs::Vector<2> pixel = toPixel(request.camera, {x, y});
            return systems::grey(copies.pixels[std::size_t(pixel.y()) * 400 + std::size_t(pixel.x())]);
        };
        QVERIFY(brightnessAt(0.08, 0.08) > 100);
        for (const auto& [x, y] : {std::pair(0.1, 0.0), std::pair(0.5, 0.1), std::pair(0.6, 0.15)}) // sides
            QVERIFY(std::max({brightnessAt(x, y), brightnessAt(x + 0.002, y), brightnessAt(x, y + 0.002)}) >
                    brightnessAt(0.08, 0.08) + 15);
        request.iterations = 1000;
        const Frame frame = render(request);
        QCOMPARE(frame.note, RenderNote::FewerIterations);
        QVERIFY(frame.iterations >= 12 && frame.iterations < 14);
    }

    void oddSystemsAreDrawnOrLeftEmpty_data() {
        QTest::addColumn<int>("which");
        QTest::addColumn<int>("note");
        QTest::addColumn<bool>("visible");
        const auto row = [](const char* name, int which, RenderNote note, bool visible) {
            QTest::newRow(name) << which << static_cast<int>(note) << visible;
        };
        row("no maps", 0, RenderNote::NoMaps, false);
        row("one map", 1, RenderNote::None, true);
        row("identical maps", 2, RenderNote::None, true);
        row("constant maps", 3, RenderNote::None, true);
        row("expanding", 4, RenderNote::NoAttractor, true);
        row("one map expands a little", 5, RenderNote::NoAttractor, true);
        row("eventually contractive", 6, RenderNote::None, true);
        row("huge coefficients", 7, RenderNote::None, true);
        row("weights off", 8, RenderNote::NoMaps, false);
        row("not finite", 9, RenderNote::NoMaps, false);
        row("on a line", 10, RenderNote::None, true);
        row("hardly contracting", 11, RenderNote::None, true);
    }

    void oddSystemsAreDrawnOrLeftEmpty() {
        QFETCH(int, which);
        QFETCH(int, note);
        QFETCH(bool, visible);
        const double nan = std::numeric_limits<double>::quiet_NaN();
        ifs::IteratedFunctionSystem<2> off = systems::maple();
        for (auto& map : off.maps)
            map.weight = -1;
        const std::vector<ifs::IteratedFunctionSystem<2>> candidates{
            {},
            systems::system({{{0.5, 0, 0, 0.5, 1, 1}}}),
            systems::system({{{0.5, 0, 0, 0.5, 1, 1}}, {{0.5, 0, 0, 0.5, 1, 1}}}),
            systems::system({{{0, 0, 0, 0, 1, 1}}, {{0, 0, 0, 0, 2, 3}}}),
            systems::system({{{1.5, 0, 0, 1.5, 0, 0}}, {{1.2, 0, 0, 1.3, 1, 1}}}),
            systems::system({{{1.05, 0, 0, 1.05, 0, 0}, 1},
                             {{0.4, 0.1, 0, 0.4, 1, 1}, 1},
                             {{0.4, 0, 0.1, 0.4, 0, 1}, 1}}),
            systems::system({{{0.5, 2, 0, 0.5, 0, 0}}, {{0.5, 0, 0.1, 0.3, 1, 0}}}),
            systems::system(
                {{{0.5, 0, 0, 0.5, 1e150, 0}}, {{0.5, 0, 0, 0.5, 0, 3e150}}, {{0.5, 0, 0, 0.5, 0, 0}}}),
            off,
            systems::system({{{nan, 0, 0, 0.5, 1, 1}, 1}}),
            systems::system({{{0.5, 0, 0, 0, 0, 0}}, {{0.5, 0, 0, 0, 0.5, 0}}}),
            systems::system({{{0.9999, 0, 0, 0.9999, 0.0001, 0}, 0.9999}, {{0.5, 0, 0, 0.5, 0, 1}, 0.0001}})};
        const auto& system = candidates[static_cast<std::size_t>(which)];
        for (const Algorithm algorithm :
             {Algorithm::Density, Algorithm::ChaosGame, Algorithm::Deterministic}) {
            RenderRequest request = systems::request(system, 200'000);
            request.algorithm = algorithm;
            request.iterations = 3;
            const Frame frame = render(request);
            QCOMPARE(frame.pixels.size(), std::size_t{320 * 200});
            QCOMPARE(static_cast<int>(frame.note), note);
            if (algorithm == Algorithm::Density) QCOMPARE(systems::meanGrey(frame) > 0, visible);
            QVERIFY(std::isfinite(frame.exposure.meanDensity) && std::isfinite(frame.exposure.whitePoint));
        }
    }

    void oddCamerasAreHarmless() {
        RenderRequest request = systems::request(systems::maple(), 10'000);
        const Camera good = request.camera;
        request.camera.width = 0;
        QCOMPARE(render(request).pixels.size(), std::size_t{0});
        request.camera = good;
        for (const double scale : {0.0, -1.0, 1e-300, 1e300, std::numeric_limits<double>::infinity(),
                                   std::numeric_limits<double>::quiet_NaN()}) {
            request.camera.pixelsPerUnit = scale;
            QCOMPARE(render(request).pixels.size(), std::size_t{320 * 200});
        }
        request.camera = good;
        request.camera.centre = {1e9, 1e9};
        QCOMPARE(systems::meanGrey(render(request)), 0.0);
    }

    void deepZoomIsFullOfDetail() {
        RenderRequest request = systems::request(systems::fern(), 1'000'000);
        request.camera.centre = *ifs::fixedPoint(request.system.maps[1].map);
        const double scale = request.camera.pixelsPerUnit;
        for (const double zoom : {1e4, 1e8, 1e12}) {
            request.camera.pixelsPerUnit = scale * zoom;
            const Frame frame = render(request);
            QCOMPARE(frame.note, RenderNote::None);
            QVERIFY(systems::meanGrey(frame) > 5);
            std::uint64_t shades = 0;
            std::array<bool, 256> seen{};
            for (const std::uint32_t pixel : frame.pixels)
                seen[static_cast<std::size_t>(systems::grey(pixel))] = true;
            for (const bool shade : seen)
                shades += shade ? 1 : 0;
            QVERIFY(shades > 40);
        }
        request.camera.pixelsPerUnit = scale * 1e17;
        QCOMPARE(render(request).note, RenderNote::TooDeep);
    }

    void aCageOfMoreVerticesMovesThePicture() {
        RenderRequest request = systems::request(systems::maple(), 300'000);
        request.cage =
            ifs::ControlCage<2>{{{-3, -2}, {3, -2}, {3, 5}, {-3, 5}}, {{-2, -2}, {4, -2}, {4, 5}, {-2, 5}}};
        const Frame moved = render(request);
        request.cage = ifs::ControlCage<2>{{{0, 0}, {1, 0}, {0, 1}}, {{1, 0}, {2, 0}, {1, 1}}};
        const Frame expected = render(request);
        int different = 0;
        for (std::size_t i = 0; i < moved.pixels.size(); ++i)
            different +=
                std::abs(systems::grey(moved.pixels[i]) - systems::grey(expected.pixels[i])) > 40 ? 1 : 0;
        QVERIFY(different < 50); // rounding of the fit moves a few samples
        QVERIFY(systems::meanGrey(moved) > 1);
    }
};

BARYCAGE_TEST(TestRenderer);
#include "renderer_test.moc"
