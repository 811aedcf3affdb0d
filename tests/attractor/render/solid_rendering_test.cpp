// SPDX-License-Identifier: MIT
#include "attractor/arithmetic/arithmetic.h"
#include "attractor/kernels/kernels.h"
#include "attractor/render/solid_rendering.h"
#include "attractor/samples/chaos_game.h"
#include "attractor/space_systems.h"
#include "support/late_stop.h"
#include "support/named_test.h"
#include "support/thorough.h"

#include <Eigen/Geometry>
#include <QtTest>

#include <chrono>
#include <cmath>
#include <random>
#include <thread>

using namespace attractor;
using systems::spaceRequest;
using systems::System3;

Q_DECLARE_METATYPE(systems::System3)

namespace {

using ifs::Vector;

DepthRaster drawn(const SpaceRequest& request) {
    SolidRendering rendering(request);
    rendering.draw();
    return rendering.takeRaster();
}

// The nearest depth of so many points of the chaos game in every pixel, in pixels of the plane of the target;
// infinite where none falls.
std::vector<double> bruteForce(const SpaceRequest& request, std::size_t points) {
    const ifs::ActiveMaps<3> active = ifs::activeMaps(request.system);
    const ifs::AffineMap<3> cage = request.cage ? ifs::displayMap(*request.cage) : ifs::AffineMap<3>();
    const OrbitCamera& camera = request.camera;
    const double scale = pixelsPerUnit(camera);
    const double eye = scale * eyeDistance(camera);
    const bool perspective = camera.projection == OrbitCamera::Projection::Perspective;
    ifs::AffineMap<3> view = worldToCamera(camera) * cage;
    view.linear *= scale;
    view.translation *= scale;
    std::vector<double> depths(std::size_t(camera.size.width) * std::size_t(camera.size.height), HUGE_VAL);
    const AliasTable table(active.probabilities);
    Vector<3> x = *ifs::fixedPoint(active.maps.front());
    for (std::size_t n = 0; n < points; ++n) {
        x = active.maps[std::size_t(table.draw(std::uint32_t(mixed(n) >> 32)))](x);
        const Vector<3> seen = view(x);
        const double shrink = perspective ? eye / (eye + seen.z()) : 1;
        const double column = camera.size.width / 2.0 + shrink * seen.x();
        const double row = camera.size.height / 2.0 - shrink * seen.y();
        if (!(column >= 0 && column < camera.size.width && row >= 0 && row < camera.size.height)) continue;
        double& depth = depths[std::size_t(row) * std::size_t(camera.size.width) + std::size_t(column)];
        depth = std::min(depth, seen.z());
    }
    return depths;
}

struct Agreement {
    std::size_t filled = 0;   // pixels, by brute force
    std::size_t missed = 0;   // of them, those with a point a pixel nearer than all that is drawn around
    std::size_t farther = 0;  // of them, those that are drawn farther by more than a pixel
    std::size_t drawn = 0;    // pixels
    std::size_t invented = 0; // of them, those a pixel nearer than all points around
};

Agreement agreement(const DepthRaster& raster, const std::vector<double>& brute, double pixelsPerUnit) {
    Agreement result;
    const auto at = [&](int x, int y) { return std::size_t(y) * std::size_t(raster.width) + std::size_t(x); };
    const auto depth = [&](int x, int y) {
        const std::uint32_t key = raster.keys[at(x, y)];
        return key == emptyKey ? HUGE_VAL : depthOf(raster, key) * pixelsPerUnit;
    };
    const auto around = [&](int x, int y, const auto& isMatch) {
        for (int v = std::max(0, y - 1); v <= std::min(raster.height - 1, y + 1); ++v)
            for (int u = std::max(0, x - 1); u <= std::min(raster.width - 1, x + 1); ++u)
                if (isMatch(u, v)) return true;
        return false;
    };
    for (int y = 0; y < raster.height; ++y)
        for (int x = 0; x < raster.width; ++x) {
            const double wanted = brute[at(x, y)];
            const double found = depth(x, y);
            if (std::isfinite(wanted)) {
                ++result.filled;
                result.farther += found > wanted + 1 ? 1 : 0;
                result.missed +=
                    around(x, y, [&](int u, int v) { return depth(u, v) <= wanted + 1; }) ? 0 : 1;
            }
            if (std::isfinite(found)) {
                ++result.drawn;
                result.invented +=
                    around(x, y, [&](int u, int v) { return brute[at(u, v)] <= found + 1; }) ? 0 : 1;
            }
        }
    return result;
}

// Maps that turn and shrink at random, many of which are so large that their pieces lie on each other.
System3 randomOverlaps(unsigned seed) {
    std::mt19937 random(seed);
    const auto from = [&](double low, double high) { return low + (high - low) * random() * 0x1p-32; };
    const auto turn = [&] {
        Eigen::Quaterniond q(from(-1, 1), from(-1, 1), from(-1, 1), from(-1, 1));
        return q.normalized().toRotationMatrix();
    };
    System3 system;
    const double count = std::floor(from(3, 10));
    const double scale = from(0.45, 0.85);
    for (int i = 0; i < count; ++i) {
        ifs::AffineMap<3> map;
        const ifs::Matrix<3> before = turn(), after = turn();
        Vector<3> scales;
        for (double& s : scales)
            s = std::min(0.95, from(0.5, 1.5) * scale);
        map.linear = after * scales.asDiagonal() * before;
        for (double& x : map.translation)
            x = from(-1, 1);
        ifs::append<3>(system, map);
    }
    return system;
}

System3 named(const QString& name) {
    return name == u"menger"        ? systems::menger()
           : name == u"tetrahedron" ? systems::tetrahedron()
                                    : systems::fern3();
}

SpaceRequest requestFor(const QString& name, bool perspective, int width, int height) {
    SpaceRequest request = spaceRequest(named(name), width, height);
    if (perspective) {
        request.camera.projection = OrbitCamera::Projection::Perspective;
        request.camera =
            fitted(request.camera, *ifs::SupportFunction<3>::of(ifs::mapsOf(request.system)), {});
    }
    return request;
}

} // namespace

class TestSolidRendering : public QObject {
    Q_OBJECT

private slots:
    void agreesWithBruteForce_data() {
        QTest::addColumn<QString>("system");
        QTest::addColumn<bool>("perspective");
        for (const char* name : {"menger", "tetrahedron", "fern3"})
            for (const bool perspective : {false, true})
                QTest::addRow("%s%s", name, perspective ? ", perspective" : "")
                    << QString::fromLatin1(name) << perspective;
    }
    void agreesWithBruteForce() {
        QFETCH(QString, system);
        QFETCH(bool, perspective);
        const SpaceRequest request = requestFor(system, perspective, 160, 120);
        const DepthRaster raster = drawn(request);
        const auto brute = bruteForce(request, 20'000'000);
        const Agreement found = agreement(raster, brute, pixelsPerUnit(request.camera));
        qInfo("filled %zu missed %zu farther %zu, drawn %zu invented %zu", found.filled, found.missed,
              found.farther, found.drawn, found.invented);
        QVERIFY(found.filled > 500);
        QVERIFY(found.missed <= found.filled / 1000);
        QVERIFY(found.farther <= found.filled / 5); // along edges that cross less than half of a pixel
        QVERIFY(found.invented <= found.drawn / 1000);
    }

    // There are more words than can be looked at; what is drawn of them leaves few holes.
    void heavyOverlapsAreFilled() {
        const SpaceRequest request = spaceRequest(systems::heavyOverlaps(), 160, 120);
        SolidRendering rendering(request);
        QVERIFY(rendering.draw());
        const auto brute = bruteForce(request, 5'000'000);
        const Agreement found = agreement(rendering.raster(), brute, pixelsPerUnit(request.camera));
        qInfo("filled %zu missed %zu farther %zu, drawn %zu", found.filled, found.missed, found.farther,
              found.drawn);
        QVERIFY(found.filled > 500);
        QVERIFY(found.missed <= found.filled / 100);
    }

    // Whatever overlaps: parts are missing only where the picture says that they may be.
    void nothingIsMissingUnsaid_data() {
        QTest::addColumn<unsigned>("seed");
        QTest::addColumn<bool>("isCoarse");
        for (const unsigned seed : {1U, 12U, 13U})
            QTest::addRow("too many words, %u", seed) << seed << true;
        for (const unsigned seed : {2U, 9U, 10U})
            QTest::addRow("all of it, %u", seed) << seed << false;
    }
    void nothingIsMissingUnsaid() {
        QFETCH(unsigned, seed);
        const SpaceRequest request = spaceRequest(randomOverlaps(seed), 240, 180);
        SolidRendering rendering(request);
        QVERIFY(rendering.draw());
        QTEST(rendering.work().isCoarse, "isCoarse");
        const auto brute = bruteForce(request, 3'000'000);
        const Agreement found = agreement(rendering.raster(), brute, pixelsPerUnit(request.camera));
        qInfo("filled %zu missed %zu", found.filled, found.missed);
        QVERIFY(found.filled > 500);
        QVERIFY(rendering.work().isCoarse || found.missed <= found.filled / 1000);
    }

    // What is drawn are points of the attractor.
    void liesInTheCertifiedHull() {
        for (const char* name : {"menger", "tetrahedron", "fern3"})
            for (const bool perspective : {false, true}) {
                const SpaceRequest request = requestFor(QString::fromLatin1(name), perspective, 320, 240);
                const auto support = *ifs::SupportFunction<3>::of(ifs::mapsOf(request.system));
                const DepthRaster raster = drawn(request);
                std::vector<std::pair<Vector<3>, double>> halfSpaces;
                for (int n = 0; n < 60; ++n) {
                    const Vector<3> u = orbit(n * 137.5, std::asin((n + 0.5) / 30 - 1) * 180 / M_PI)
                                            .toRotationMatrix()
                                            .col(2);
                    const auto value = support(u, 1e-3 * support.radius());
                    halfSpaces.emplace_back(u, value.value + value.error);
                }
                // Half the diagonal of a pixel, magnified towards the eye, and half a pixel of a bend.
                const double room = 1.5 / pixelsPerUnit(request.camera);
                std::size_t points = 0;
                for (int y = 0; y < raster.height; ++y)
                    for (int x = 0; x < raster.width; ++x) {
                        const std::uint32_t key = raster.keys[std::size_t(y * raster.width + x)];
                        if (key == emptyKey) continue;
                        ++points;
                        const Vector<3> at =
                            toWorld(request.camera, {{x + 0.5, y + 0.5}, depthOf(raster, key)});
                        for (const auto& [u, h] : halfSpaces)
                            QVERIFY(u.dot(at) <= h + room);
                    }
                QVERIFY(points > 1000);
            }
    }

    void sameBytesWhateverThreadsAndInstructions() {
        for (const char* name : {"menger", "tetrahedron", "fern3"})
            for (const bool perspective : {false, true}) {
                SpaceRequest request = requestFor(QString::fromLatin1(name), perspective, 333, 301);
                request.camera.height /= 1.5;
                const DepthRaster wanted = drawn(request);
                QVERIFY(std::ranges::any_of(wanted.keys, [](std::uint32_t key) { return key != emptyKey; }));
                const std::string usual = simdName();
                for (const std::string& simd : simdNames())
                    for (const int threads : {1, 2, 3}) {
                        QVERIFY(selectSimd(simd));
                        request.threads = threads;
                        const DepthRaster found = drawn(request);
                        QVERIFY(selectSimd(usual));
                        QCOMPARE(found.near, wanted.near);
                        QCOMPARE(found.far, wanted.far);
                        QVERIFY2(found.keys == wanted.keys, simd.c_str());
                    }
            }
    }

    // Whatever is drawn, it is defined, bounded in time, and says why it may not be what is expected.
    void hostileSystems_data() {
        QTest::addColumn<System3>("system");
        QTest::addColumn<int>("note");
        QTest::addColumn<bool>("shows");
        const auto row = [](const char* name, const System3& system, RenderNote note, bool shows) {
            QTest::newRow(name) << system << int(note) << shows;
        };
        row("nothing", {}, RenderNote::NoMaps, false);
        System3 point;
        ifs::append<3>(point, systems::scaled(0.5, 1, 2, 3));
        row("a point", point, RenderNote::None, true);
        System3 constant;
        for (int i = 0; i < 5; ++i)
            ifs::append<3>(constant, systems::scaled(0, i, i * i, 1));
        row("constant maps", constant, RenderNote::None, true);
        System3 flat = systems::menger();
        for (auto& map : flat.maps)
            map.map.linear.row(2).setZero(), map.map.translation.z() = 0;
        row("flat", flat, RenderNote::None, true);
        System3 needle = systems::menger();
        for (auto& map : needle.maps)
            map.map.translation.tail<2>() *= 1e-9;
        row("needle", needle, RenderNote::None, true);
        System3 slow;
        for (const double x : {0.0, 1e-3}) {
            ifs::AffineMap<3> map = systems::scaled(0.3, x, x, 0.1);
            map.linear(0, 0) = 0.999;
            ifs::append<3>(slow, map);
        }
        row("slow", slow, RenderNote::None, true);
        System3 huge = systems::tetrahedron();
        for (auto& map : huge.maps)
            map.map.translation *= 1e150;
        row("huge", huge, RenderNote::None, true);
        System3 overlapping;
        for (int i = 0; i < 12; ++i)
            ifs::append<3>(overlapping, systems::scaled(0.9, 0.01 * i, 0.01 * (i % 3), 0.01 * (i % 5)));
        row("overlapping", overlapping, RenderNote::None, true);
        System3 many;
        for (int i = 0; i < 10'000; ++i)
            ifs::append<3>(many,
                           systems::scaled(0.02, (i % 22) / 22.0, (i / 22 % 22) / 22.0, i / 484 / 22.0));
        row("ten thousand maps", many, RenderNote::None, true);
        System3 expanding;
        for (const double x : {0.0, 1.0})
            ifs::append<3>(expanding, systems::scaled(1.5, x, 0, 0));
        row("no attractor", expanding, RenderNote::NoAttractor, true);
        System3 bad = systems::tetrahedron();
        bad.maps[0].map.linear(0, 0) = NAN;
        row("not a number", bad, RenderNote::None, true);
    }
    void hostileSystems() {
        QFETCH(System3, system);
        QFETCH(int, note);
        QFETCH(bool, shows);
        const auto begin = std::chrono::steady_clock::now();
        for (const auto projection :
             {OrbitCamera::Projection::Orthographic, OrbitCamera::Projection::Perspective}) {
            SpaceRequest request = spaceRequest(system, 200, 150);
            request.camera.projection = projection;
            SolidRendering rendering(request);
            QVERIFY(rendering.draw());
            QCOMPARE(int(rendering.note()), note);
            const auto& keys = rendering.raster().keys;
            QCOMPARE(keys.size(), std::size_t(200 * 150));
            QCOMPARE(std::ranges::any_of(keys, [](std::uint32_t key) { return key != emptyKey; }), shows);
            QVERIFY(rendering.raster().near < rendering.raster().far);
            QVERIFY(std::isfinite(rendering.raster().near) && std::isfinite(rendering.raster().far));
        }
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
        QVERIFY2(seconds.count() < 60, qPrintable(QString::number(seconds.count())));
    }

    void anyCameraIsBounded() {
        const auto begin = std::chrono::steady_clock::now();
        for (const double zoom : {1.0, 1e3, 1e6, 1e10, 1e16})
            for (const auto projection :
                 {OrbitCamera::Projection::Orthographic, OrbitCamera::Projection::Perspective})
                for (const auto& [azimuth, elevation] :
                     {std::pair{0., 0.}, {45., 0.}, {30., 20.}, {0., 90.}}) {
                    if (elevation == 0 && !support::isThorough()) continue;
                    SpaceRequest request = spaceRequest(systems::menger(), 160, 120, azimuth, elevation);
                    request.camera.projection = projection;
                    request.camera.target = {0, 0, 0}; // a corner: of the attractor
                    request.camera.height = 2 / zoom;
                    SolidRendering rendering(request);
                    QVERIFY(rendering.draw());
                    QVERIFY(std::ranges::any_of(rendering.raster().keys,
                                                [](std::uint32_t key) { return key != emptyKey; }));
                    if (zoom == 1) QCOMPARE(rendering.note(), RenderNote::None);
                    if (zoom == 1e10 && projection == OrbitCamera::Projection::Orthographic)
                        QCOMPARE(rendering.note(), RenderNote::TooFar);
                    if (zoom == 1e16) QCOMPARE(rendering.note(), RenderNote::TooDeep);
                }
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
        QVERIFY2(seconds.count() < 120, qPrintable(QString::number(seconds.count())));
    }

    void badCamerasDrawNothing() {
        SpaceRequest request = spaceRequest(systems::menger(), 40, 30);
        request.camera.height = NAN;
        SolidRendering rendering(request);
        QVERIFY(rendering.draw());
        QVERIFY(
            std::ranges::all_of(rendering.raster().keys, [](std::uint32_t key) { return key == emptyKey; }));
        request.camera.size = {0, 0};
        rendering.restart(request);
        QVERIFY(rendering.draw());
        QVERIFY(rendering.raster().keys.empty());
    }

    // A tetrahedron squeezed flat has a picture, and opened again it has the same as before, bit by bit.
    void squeezingLosesNothing() {
        SpaceRequest request = spaceRequest(systems::menger(), 200, 150);
        ifs::ControlCage<3> cage = ifs::polygonAtRest<3>({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}});
        cage.current[3] = {0.3, 0.1, 1.5};
        request.cage = cage;
        SolidRendering rendering(request);
        QVERIFY(rendering.draw());
        const DepthRaster before = rendering.takeRaster();
        request.cage->current[3] = {0.5, 0.25, 0};
        rendering.restart(request);
        QVERIFY(rendering.draw());
        QCOMPARE(rendering.note(), RenderNote::Degenerate);
        QVERIFY(
            std::ranges::any_of(rendering.raster().keys, [](std::uint32_t key) { return key != emptyKey; }));
        request.cage = cage;
        rendering.restart(request);
        QVERIFY(rendering.draw());
        QVERIFY(rendering.raster().keys == before.keys);
        QVERIFY(before.keys != drawn(spaceRequest(systems::menger(), 200, 150)).keys);
    }

    // The cage is one affine map more: the picture is that of the baked system, but for rounding.
    void theCageIsAnAffineMap() {
        SpaceRequest request = spaceRequest(systems::tetrahedron(), 200, 150);
        ifs::ControlCage<3> cage = ifs::polygonAtRest<3>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
        cage.current = {{0.1, 0, 0}, {1.2, 0.3, 0}, {0, 0.8, 0.2}, {0.1, 0.1, 0.9}};
        request.cage = cage;
        const auto brute = bruteForce(request, 10'000'000);
        const DepthRaster raster = drawn(request);
        const Agreement found = agreement(raster, brute, pixelsPerUnit(request.camera));
        QVERIFY(found.filled > 1000);
        QVERIFY(found.missed <= found.filled / 1000);
        QVERIFY(found.invented <= found.drawn / 1000);
    }

    // The lower bits of a key name the first map.
    void colourIsTheFirstMap() {
        const SpaceRequest request = spaceRequest(systems::tetrahedron(), 200, 150);
        const DepthRaster raster = drawn(request);
        const auto maps = ifs::mapsOf(request.system);
        std::array<int, 4> seen{};
        for (int y = 0; y < raster.height; ++y)
            for (int x = 0; x < raster.width; ++x) {
                const std::uint32_t key = raster.keys[std::size_t(y * raster.width + x)];
                if (key == emptyKey) continue;
                const Vector<3> at = toWorld(request.camera, {{x + 0.5, y + 0.5}, depthOf(raster, key)});
                const std::uint8_t colour = colourIndex(key);
                QVERIFY(colour < 4);
                ++seen[colour];
                // Its image of the cube around the attractor.
                const Vector<3> inner = ifs::inverse(maps[colour])->operator()(at);
                const double room = 3 / pixelsPerUnit(request.camera);
                QVERIFY(inner.minCoeff() > -room && inner.maxCoeff() < 1 + room);
            }
        for (const int count : seen)
            QVERIFY(count > 100);
    }

    void depthRangeIsTight() {
        for (const char* name : {"menger", "tetrahedron", "fern3"}) {
            const SpaceRequest request = requestFor(QString::fromLatin1(name), false, 320, 240);
            const DepthRaster raster = drawn(request);
            std::uint32_t low = maxDepthCode;
            std::uint32_t high = 0;
            for (const std::uint32_t key : raster.keys)
                if (key != emptyKey) {
                    low = std::min(low, depthCode(key));
                    high = std::max(high, depthCode(key));
                }
            QVERIFY(low > 0 && high < maxDepthCode);
            QVERIFY(low < maxDepthCode / 40);
        }
    }

    void stopsSoonAfterItIsAsked() {
        SolidRendering rendering(spaceRequest(systems::menger(), 3000, 2000));
        for (const int wait : {0, 5, 30}) {
            auto soonest = Clock::duration::max(); // of several: a busy machine makes any one late
            for (int attempt = 0; attempt < 8; ++attempt)
                soonest = std::min(soonest, lateness(rendering, std::chrono::milliseconds(wait)));
            const auto began = Clock::now();
            QVERIFY(rendering.draw());
            QVERIFY2(soonest < (Clock::now() - began) / 8,
                     qPrintable(QString::number(std::chrono::duration<double>(soonest).count())));
        }
    }

    // Of the raster of a large picture, which takes seconds to be cleared.
    void noRoomIsMadeForWhatIsNotWanted() {
        SolidRendering rendering(spaceRequest(systems::menger(), 3000, 2000));
        std::stop_source source;
        source.request_stop();
        QVERIFY(!rendering.draw(source.get_token()));
        QVERIFY(rendering.raster().keys.empty());
        QCOMPARE(rendering.raster().width, 0);
        QVERIFY(rendering.draw());
        QCOMPARE(rendering.raster().keys.size(), std::size_t(3000) * 2000);
    }

private:
    using Clock = std::chrono::steady_clock;

    // From the request to stop, made after the wait, to the end of the drawing; the longest there is if it
    // was finished before.
    static Clock::duration lateness(SolidRendering& rendering, Clock::duration wait) {
        support::LateStop stop(wait);
        const bool finished = rendering.draw(stop.token());
        const auto ended = Clock::now();
        return finished ? Clock::duration::max() : ended - stop.asked();
    }
};

BARYCAGE_TEST(TestSolidRendering);
#include "solid_rendering_test.moc"
