// SPDX-License-Identifier: MIT
#include "attractor/arithmetic/arithmetic.h"
#include "attractor/light/stereo.h"
#include "attractor/render/cloud_rendering.h"
#include "attractor/render/solid_rendering.h"
#include "attractor/samples/chaos_game.h"
#include "attractor/solid/space_view.h"
#include "attractor/space_systems.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

using namespace attractor;
using ifs::Vector;

namespace {

DepthRaster drawnSlice(const SpaceRequest& request) {
    SolidRendering rendering(request);
    rendering.draw();
    return rendering.takeRaster();
}

// Which pixels show something.
struct Mask {
    int width = 0;
    int height = 0;
    std::vector<bool> set;

    bool at(int x, int y) const {
        return x >= 0 && x < width && y >= 0 && y < height &&
               set[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    }
    bool around(double x, double y) const { // within a pixel of this point
        for (int v = int(std::floor(y)) - 1; v <= int(std::floor(y)) + 1; ++v)
            for (int u = int(std::floor(x)) - 1; u <= int(std::floor(x)) + 1; ++u)
                if (at(u, v)) return true;
        return false;
    }
    std::size_t count() const { return std::size_t(std::ranges::count(set, true)); }
};

Mask maskOf(const DepthRaster& raster) {
    Mask mask{raster.width, raster.height, {}};
    for (const std::uint32_t key : raster.keys)
        mask.set.push_back(key != emptyKey);
    return mask;
}

// Menger's sponge cut through its centre across its diagonal, which is the line of sight.
SpaceRequest hexagram(int side) {
    SpaceRequest request = systems::spaceRequest(systems::menger(), side, side, 45,
                                                 90 - std::atan(std::sqrt(2)) * 180 / std::numbers::pi);
    request.camera.target = {0.5, 0.5, 0.5};
    request.camera.height = 1.6;
    request.clip = SpaceClip{{1, 1, 1}, 1.5, 1.5};
    return request;
}

SpaceRequest slab(bool perspective) {
    SpaceRequest request = systems::spaceRequest(systems::menger(), 240, 180);
    if (perspective) request.camera.projection = OrbitCamera::Projection::Perspective;
    request.clip = SpaceClip{{1, -2, 0.5}, -0.6, 0.1};
    return request;
}

// What is near is red, what is far blue.
SpaceRequest redAndBlueXRay(const systems::System3& system, double azimuth) {
    SpaceRequest request = systems::spaceRequest(system, 80, 80, azimuth, 0);
    request.samples = 2'000'000;
    request.cloudColour = CloudColour::MeanDepth;
    request.appearance.background = {0, 0, 0, 255};
    request.appearance.palette = {"two", {{0, {0, 0, 255, 255}}, {1, {255, 0, 0, 255}}}};
    return request;
}

// The share of red in the light of the columns [first, end) of such a picture.
double shareOfRed(const SpaceRequest& request, int first = 0, int end = 80) {
    CloudRendering rendering(request);
    rendering.refine();
    std::vector<std::uint32_t> pixels(std::size_t(80 * 80));
    rendering.tone(pixels);
    double red = 0, blue = 0;
    for (int k = 0; k < 80 * 80; ++k) {
        if (k % 80 < first || k % 80 >= end) continue;
        red += pixels[std::size_t(k)] >> 16 & 0xFF;
        blue += pixels[std::size_t(k)] & 0xFF;
    }
    return red / (red + blue);
}

} // namespace

class SliceTest : public QObject {
    Q_OBJECT

private slots:
    // SPACE: a hexagon with holes in the shape of hexagrams, equal to its rotation by 60° to one pixel.
    void mengerAcrossItsDiagonalIsAHexagonWithHexagrams() {
        const SpaceRequest request = hexagram(640);
        const Mask mask = maskOf(drawnSlice(request));
        QVERIFY(mask.count() > 20'000);
        const double middle = 320, unit = pixelsPerUnit(request.camera);
        const double c = 0.5, s = std::sqrt(0.75);
        std::size_t unequal = 0, outside = 0;
        for (int y = 0; y < mask.height; ++y)
            for (int x = 0; x < mask.width; ++x) {
                if (!mask.at(x, y)) continue;
                const double right = x + 0.5 - middle, down = y + 0.5 - middle;
                unequal += mask.around(middle + c * right - s * down, middle + s * right + c * down) ? 0 : 1;
                outside += std::hypot(right, down) > std::sqrt(0.5) * unit + 2 ? 1 : 0;
            }
        QCOMPARE(unequal, 0U);
        QCOMPARE(outside, 0U);
        // The corners of the hexagon are middles of edges of the cube, which belong to the sponge.
        std::size_t corners = 0;
        for (int k = 0; k < 12; ++k) {
            const double angle = k * std::numbers::pi / 6, reach = std::sqrt(0.5) * unit - 1;
            corners +=
                mask.around(middle + reach * std::cos(angle), middle + reach * std::sin(angle)) ? 1 : 0;
        }
        QCOMPARE(corners, 6U);
        // The tips of the star in the middle are √6/6 from it, its notches √2/6: on a circle between them six
        // arcs are empty, and six are not.
        QVERIFY(!mask.around(middle, middle));
        std::size_t empty = 0;
        constexpr int directions = 360;
        const double reach = 0.25 * unit;
        int changes = 0;
        bool was = mask.around(middle + reach, middle);
        for (int k = 1; k <= directions; ++k) {
            const double angle = 2 * std::numbers::pi * k / directions;
            const bool is = mask.around(middle + reach * std::cos(angle), middle + reach * std::sin(angle));
            empty += is ? 0 : 1;
            changes += is != was ? 1 : 0;
            was = is;
        }
        QCOMPARE(changes, 12);
        QVERIFY(empty > 0);
    }

    void agreesWithBruteForce_data() {
        QTest::addColumn<bool>("perspective");
        QTest::newRow("orthographic") << false;
        QTest::newRow("perspective") << true;
    }
    // Every point of the attractor in the slab is seen, or something nearer is; and all that is seen is in
    // it.
    void agreesWithBruteForce() {
        QFETCH(bool, perspective);
        const SpaceRequest request = slab(perspective);
        const DepthRaster raster = drawnSlice(request);
        const double unit = pixelsPerUnit(request.camera);
        const ifs::ActiveMaps<3> active = ifs::activeMaps(request.system);
        const AliasTable table(active.probabilities);
        Vector<3> x = *ifs::fixedPoint(active.maps.front());
        std::size_t within = 0, missed = 0;
        for (std::size_t n = 0; n < 3'000'000; ++n) {
            x = active.maps[std::size_t(table.draw(std::uint32_t(mixed(n) >> 32)))](x);
            const double at = request.clip->normal.dot(x);
            if (at < request.clip->lowest || at > request.clip->highest) continue;
            const ScreenPoint seen = toScreen(request.camera, x);
            ++within;
            bool isThere = false;
            for (int v = -1; v <= 1; ++v)
                for (int u = -1; u <= 1; ++u) {
                    const int column = int(std::floor(seen.pixel.x())) + u;
                    const int row = int(std::floor(seen.pixel.y())) + v;
                    if (column < 0 || column >= raster.width || row < 0 || row >= raster.height) continue;
                    const std::uint32_t key =
                        raster.keys[std::size_t(row) * std::size_t(raster.width) + std::size_t(column)];
                    isThere = isThere || (key != emptyKey && depthOf(raster, key) <= seen.depth + 1 / unit);
                }
            missed += isThere ? 0 : 1;
        }
        QVERIFY(within > 100'000);
        QCOMPARE(missed, 0U);
        const double pixel = 2.5 * request.clip->normal.norm() / unit;
        for (int row = 0; row < raster.height; ++row)
            for (int column = 0; column < raster.width; ++column) {
                const std::uint32_t key =
                    raster.keys[std::size_t(row) * std::size_t(raster.width) + std::size_t(column)];
                if (key == emptyKey) continue;
                const Vector<3> seen =
                    toWorld(request.camera, {{column + 0.5, row + 0.5}, depthOf(raster, key)});
                const double at = request.clip->normal.dot(seen);
                QVERIFY2(at >= request.clip->lowest - pixel && at <= request.clip->highest + pixel,
                         qPrintable(QString::number(at)));
            }
    }

    void aClipAroundEverythingChangesNothing() {
        SpaceRequest request = systems::spaceRequest(systems::fern3(), 200, 150);
        const DepthRaster whole = drawnSlice(request);
        request.clip = SpaceClip{{0, 3, 1}, -1e3, 1e3};
        const DepthRaster clipped = drawnSlice(request);
        QCOMPARE(clipped.keys, whole.keys);
        request.clip = SpaceClip{{0, 3, 1}, 1e3, HUGE_VAL};
        QCOMPARE(maskOf(drawnSlice(request)).count(), 0U);
    }

    void theHalfInFrontIsGone() {
        SpaceRequest request = systems::spaceRequest(systems::menger(), 200, 150, 0, 0); // from +z
        request.clip = SpaceClip{{0, 0, 2}, -HUGE_VAL, 1};
        const DepthRaster raster = drawnSlice(request);
        const double nearest = 0.5 - request.camera.target.z();
        std::size_t seen = 0;
        for (const std::uint32_t key : raster.keys) {
            if (key == emptyKey) continue;
            ++seen;
            QVERIFY(-depthOf(raster, key) <= nearest + 1.5 / pixelsPerUnit(request.camera));
        }
        QVERIFY(seen > 5'000);
    }

    void threadsChangeNoByte() {
        SpaceRequest request = slab(true);
        const DepthRaster one = drawnSlice(request);
        request.threads = 3;
        QCOMPARE(drawnSlice(request).keys, one.keys);
    }

    // Flat, tiny, huge and far planes draw something defined.
    void hostileClipsEnd() {
        for (const SpaceClip& clip :
             {SpaceClip{{1e-300, 0, 0}, 0, 1e-301}, SpaceClip{{1e300, 1e300, 0}, 0, 1e300},
              SpaceClip{{1, 0, 0}, 1e300, HUGE_VAL}, SpaceClip{{0, 0, 0}, 0, 1}, SpaceClip{{NAN, 0, 0}, 0, 1},
              SpaceClip{{1, 0, 0}, 2, 1}}) {
            SpaceRequest request = systems::spaceRequest(systems::menger(), 60, 40);
            request.clip = clip;
            QCOMPARE(drawnSlice(request).keys.size(), 2400U);
        }
        SpaceRequest inside = hexagram(100); // between the planes, at a billion times
        inside.camera.height = 1e-9;
        inside.camera.target = {0, 0.5, 1};
        QCOMPARE(drawnSlice(inside).keys.size(), 10'000U);
    }

    // Where a cloud is cut, what is left keeps its density.
    void aCloudIsCut() {
        SpaceRequest request = systems::spaceRequest(systems::menger(), 120, 90, 0, 0);
        request.samples = 400'000;
        request.appearance.background = {0, 0, 0, 255};
        request.clip = SpaceClip{{1, 0, 0}, -HUGE_VAL, 0.5};
        CloudRendering rendering(request);
        QVERIFY(rendering.refine());
        std::vector<std::uint32_t> pixels(std::size_t(120 * 90));
        QVERIFY(rendering.tone(pixels));
        std::size_t left = 0, right = 0;
        for (int y = 0; y < 90; ++y)
            for (int x = 0; x < 120; ++x) {
                const bool isLit = (pixels[std::size_t(y * 120 + x)] & 0xFFFFFF) != 0;
                left += isLit && x < 60 ? 1 : 0;
                right += isLit && x > 61 ? 1 : 0;
            }
        QVERIFY(left > 500);
        QCOMPARE(right, 0U);
    }

    // What is nearest is shown by the end of the palette, what is farthest by its beginning.
    void anXRayShowsMeanDepth() {
        systems::System3 cube;
        for (int k = 0; k < 8; ++k)
            ifs::append<3>(cube, systems::scaled(0.5, 0.5 * (k & 1), 0.5 * (k >> 1 & 1), 0.5 * (k >> 2 & 1)));
        SpaceRequest request = redAndBlueXRay(cube, 45);
        request.clip = SpaceClip{{1, 0, 1}, 1.7, 2}; // the edge towards the eye
        // Alone, each slice has depths of its own: in the middle between near and far on the average.
        const double alone = shareOfRed(request);
        QVERIFY2(alone > 0.3 && alone < 0.7, qPrintable(QString::number(alone)));
        request.clip.reset();
        request.camera.orientation = orbit(0, 0);
        const double whole = shareOfRed(request);
        QVERIFY2(whole > 0.3 && whole < 0.7, qPrintable(QString::number(whole)));
    }

    // Of two bodies side by side, the left one is nearer.
    void theEndOfThePaletteIsNear() {
        systems::System3 pair;
        for (const double side : {-1.0, 1.0})
            ifs::append<3>(pair, systems::scaled(0.3, side, 0, -side));
        const SpaceRequest request = redAndBlueXRay(pair, 0);
        const double left = shareOfRed(request, 0, 40), right = shareOfRed(request, 40, 80);
        QVERIFY2(left > 0.6, qPrintable(QString::number(left)));
        QVERIFY2(right < 0.4, qPrintable(QString::number(right)));
    }

    // 0.2126·200 + 0.7152·100 + 0.0722·50 = 117.65 is the red of the first picture.
    void anAnaglyphJoinsColours() {
        const std::vector<std::uint32_t> left{0xFFC86432}, right{0xFF0A141E}, both{0xFF76141E};
        QCOMPARE(joined(Stereo::Anaglyph, left, right, 1), both);
        const std::vector<Rgba16> fineLeft{Rgba16{60000, 30000, 10000, 65535}};
        const std::vector<Rgba16> fineRight{Rgba16{1, 2, 3, 65535}}, fine{Rgba16{34934, 2, 3, 65535}};
        QVERIFY(joined(Stereo::Anaglyph, fineLeft, fineRight, 1) == fine);
    }

    // Each eye stands beside the camera and looks straight ahead; its picture is shifted so that the target
    // stays in place: projected from the eye onto the plane of the target.
    void anEyeBesideTheCameraSeesWhatIsProjectedFromThere() {
        OrbitCamera camera;
        camera.size = {400, 300};
        camera.height = 3;
        camera.target = {0.3, -0.2, 0.5};
        camera.orientation = orbit(33, -12, 20);
        camera.projection = OrbitCamera::Projection::Perspective;
        const double distance = eyeDistance(camera), unit = pixelsPerUnit(camera);
        for (const double shift : {-1.0 / 60, 1.0 / 60}) {
            QCOMPARE(std::abs(shift), stereoEye);
            const SpaceView view = spaceView(camera, {}, shift);
            for (const Vector<3>& point :
                 {Vector<3>(0.3, -0.2, 0.5), Vector<3>(1, 1, 1), Vector<3>(-1, 0.5, 0)}) {
                const Vector<3> at = worldToCamera(camera)(point);
                const double eye = shift * distance;
                const double x = eye + (at.x() - eye) * distance / (distance + at.z());
                const double y = at.y() * distance / (distance + at.z());
                ifs::AffineMap<3> word;
                word.linear *= 1e-9;
                word.translation = point;
                const SeenWord seenAt = seen(view.toPixels * word, view);
                QVERIFY(std::abs(seenAt.onScreen.translation.x() - (200 + unit * x)) < 1e-6);
                QVERIFY(std::abs(seenAt.onScreen.translation.y() - (150 - unit * y)) < 1e-6);
            }
        }
    }
};

BARYCAGE_TEST(SliceTest);
#include "slice_test.moc"
