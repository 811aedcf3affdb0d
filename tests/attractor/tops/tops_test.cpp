// SPDX-License-Identifier: MIT
#include "attractor/kernels/kernels.h"
#include "attractor/tops/exact_tops.h"
#include "attractor/tops/key_tops.h"
#include "attractor/tops/stolen_picture.h"
#include "ifs/canonical_systems.h"
#include "ifs/tops/fractal_transformation.h"
#include "ifs/tops/top_systems.h"
#include "support/named_test.h"

#include <QTest>

#include <cmath>

using attractor::Camera;
using attractor::CoupledSystem;
using attractor::TopPoint;
using ifs::Vector;
using namespace tops;
using Points = std::vector<TopPoint>;

// Tops of a picture, by samples and exactly, and the colours that are stolen with them.
class TopsTest : public QObject {
    Q_OBJECT

private slots:
    void cleanup();
    void exactPixelsHoldTheirTops_data();
    void exactPixelsHoldTheirTops();
    void samplesAgreeWithTheExactPicture_data();
    void samplesAgreeWithTheExactPicture();
    void morePointsOnlyRaise();
    void bandsDoNotMatter();
    void equalSystemsGiveTheIdentity_data();
    void equalSystemsGiveTheIdentity();
    void pixelsShowTheTransformation();
    void reversedOrderDiffersOnTheOverlap();
    void everyPictureIsTheSame_data();
    void everyPictureIsTheSame();
    void identityCopiesThePicture();
    void conjugacyMovesThePicture_data();
    void conjugacyMovesThePicture();
    void pixelsOfSquaresShowTheTransformation();
    void hostileSystems_data();
    void hostileSystems();
    void stops();
};

namespace {

std::vector<double> equalWeights(const Maps& maps) {
    return ifs::equalWeights(maps.size());
}

CoupledSystem coupled(const Maps& from, const Maps& to) {
    return {attractorOf(from), attractorOf(to), ifs::determinantWeights<2>(from)};
}

Camera cameraOf(const Maps& maps, int width, int height) {
    const auto& h = ifs::EnclosingPolygon(attractorOf(maps)).heights;
    Camera camera;
    camera.width = width;
    camera.height = height;
    return fitted(camera, {-h[8], -h[12]}, {h[0], h[4]});
}

template <class Tops> Points drawn(const Tops& tops, const Camera& camera, int rows = 0) {
    Points points(std::size_t(camera.width) * std::size_t(camera.height));
    if (rows == 0) rows = camera.height;
    for (int first = 0; first < camera.height; first += rows) {
        const int count = std::min(rows, camera.height - first);
        const auto part = std::span(points).subspan(std::size_t(first) * std::size_t(camera.width),
                                                    std::size_t(count) * std::size_t(camera.width));
        if (!tops.draw(first, part, {})) return {};
    }
    return points;
}

Points exact(const CoupledSystem& system, const Camera& camera, int rows = 0) {
    return drawn(attractor::ExactTops(system, camera), camera, rows);
}

Points sampled(const CoupledSystem& system, const Camera& camera, std::uint64_t count, int rows = 0) {
    return drawn(attractor::KeyTops(system, camera, count, 1, {}), camera, rows);
}

bool same(const TopPoint& a, const TopPoint& b) {
    return a.x == b.x && a.y == b.y && a.stretch == b.stretch && a.address == b.address;
}

bool same(const Points& a, const Points& b) {
    return !a.empty() && std::ranges::equal(a, b, [](const auto& p, const auto& q) { return same(p, q); });
}

bool isOnBorder(const Vector<2>& at) {
    return (at - Vector<2>(std::round(at.x()), std::round(at.y()))).cwiseAbs().minCoeff() < 1e-5;
}

// Points of an orbit with the addresses that they have by their maps, as numbers.
struct AddressedPoint {
    Vector<2> x;
    double address;
};
std::vector<AddressedPoint> orbit(const Maps& maps, int count) {
    canonical::Random random(11);
    std::vector<AddressedPoint> points{{*ifs::fixedPoint(maps[0]), 0}};
    while (int(points.size()) < count) {
        const std::size_t i = random() % maps.size();
        points.push_back(
            {maps[i](points.back().x), (double(i) + points.back().address) / double(maps.size())});
    }
    return points;
}

void systems() {
    QTest::addColumn<Maps>("maps");
    QTest::newRow("triangle") << triangle(.5, .5, .5);
    QTest::newRow("Sierpiński") << canonical::sierpinskiEquilateral();
    QTest::newRow("maple") << canonical::maple();
    QTest::newRow("fern") << canonical::fern();
    QTest::newRow("dragon") << canonical::heighway();
    QTest::newRow("Koch") << canonical::koch();
    QTest::newRow("interval") << interval(.3);
}

} // namespace

void TopsTest::cleanup() {
    attractor::selectSimd(attractor::simdNames().front());
}

void TopsTest::exactPixelsHoldTheirTops_data() {
    systems();
}

// No point of the attractor in a pixel has an address above the pixel's, and the address is that of a point
// within a pixel of it.
void TopsTest::exactPixelsHoldTheirTops() {
    QFETCH(Maps, maps);
    const CoupledSystem system = coupled(maps, maps);
    const Camera camera = cameraOf(maps, 160, 120);
    const Points points = exact(system, camera);
    for (const AddressedPoint& point : orbit(maps, 200'000)) {
        const Vector<2> at = toPixel(camera, point.x);
        const TopPoint& top = points[std::size_t(at.y()) * 160 + std::size_t(at.x())];
        QVERIFY(!top.isEmpty() || isOnBorder(at));
        QVERIFY(top.address <= point.address + 1e-12 || isOnBorder(at));
    }
    int filled = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (points[k].isEmpty()) continue;
        ++filled;
        const Vector<2> at = toPixel(camera, {points[k].x, points[k].y}); // G is F
        const Vector<2> off = (at - Vector<2>(double(k % 160), double(k / 160))) - Vector<2>(.5, .5);
        QVERIFY(off.cwiseAbs().maxCoeff() <= 1);
        QVERIFY(std::abs(points[k].stretch - 1) < 1e-9);
    }
    QVERIFY(filled > 100);
}

void TopsTest::samplesAgreeWithTheExactPicture_data() {
    systems();
}

void TopsTest::samplesAgreeWithTheExactPicture() {
    QFETCH(Maps, maps);
    const CoupledSystem system = coupled(maps, maps);
    Camera camera = cameraOf(maps, 80, 60);
    camera.pixelsPerUnit *= 0.97; // so that no edge lies along the pixels
    camera.centre += Vector<2>(0.0123, 0.0321) * 10 / camera.pixelsPerUnit;
    const Points points = exact(system, camera), samples = sampled(system, camera, 1'000'000'000);
    // What the exact picture misses lies on the border of two pixels, to single precision.
    int both = 0, equal = 0, lost = 0, missed = 0, far = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (samples[k].isEmpty() || points[k].isEmpty()) {
            lost += points[k].isEmpty() ? 0 : 1;
            missed += samples[k].isEmpty() ? 0 : 1;
            continue;
        }
        ++both;
        missed += samples[k].address < points[k].address - 1e-9 ? 1 : 0;
        const double distance = std::hypot(points[k].x - samples[k].x, points[k].y - samples[k].y);
        // Half a pixel is the size of what is written exactly.
        if (distance * camera.pixelsPerUnit <= .5)
            ++equal;
        else if (distance * camera.pixelsPerUnit > 1.5)
            ++far;
    }
    qInfo("%d pixels, %d equal, %d only exact, %d missed, %d far", both, equal, lost, missed, far);
    QVERIFY(both > 60);
    QVERIFY(equal >= 0.99 * both);
    QVERIFY(lost <= both / 50);
    QVERIFY(missed <= 1 + both / 200);
    QCOMPARE(far, 0);
}

void TopsTest::morePointsOnlyRaise() {
    const Maps maps = overlappingInterval();
    const Camera camera = cameraOf(maps, 300, 3);
    const Points best = exact(coupled(maps, maps), camera);
    double before = 1e9;
    for (const std::uint64_t count : {3'000, 100'000, 3'000'000}) {
        const Points points = sampled(coupled(maps, maps), camera, count);
        double sum = 0;
        for (std::size_t k = 300; k < 600; ++k) {
            QVERIFY(points[k].isEmpty() || points[k].address >= best[k].address - 1e-9);
            sum += points[k].isEmpty() ? 1 : points[k].address;
        }
        QVERIFY(sum < before);
        before = sum;
    }
}

void TopsTest::bandsDoNotMatter() {
    const Maps maps = canonical::maple();
    const CoupledSystem system = coupled(maps, canonical::fern());
    const Camera camera = cameraOf(maps, 90, 70);
    const Points whole = exact(system, camera), samples = sampled(system, camera, 1'000'000);
    for (const int rows : {1, 7, 64}) {
        QVERIFY(same(exact(system, camera, rows), whole));
        QVERIFY(same(sampled(system, camera, 1'000'000, rows), samples));
    }
}

void TopsTest::equalSystemsGiveTheIdentity_data() {
    systems();
}

void TopsTest::equalSystemsGiveTheIdentity() {
    QFETCH(Maps, maps);
    const CoupledSystem system = coupled(maps, maps);
    const Camera camera = cameraOf(maps, 200, 150);
    const Points points = sampled(system, camera, 2'000'000);
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (points[k].isEmpty()) continue;
        const Vector<2> at = toPixel(camera, {points[k].x, points[k].y});
        const Vector<2> off = at - Vector<2>(double(k % 200) + .5, double(k / 200) + .5);
        QVERIFY(off.cwiseAbs().maxCoeff() <= .51);
    }
}

// In the triangle family T is a homeomorphism: a pixel shows the image of a point in it, whatever the way.
void TopsTest::pixelsShowTheTransformation() {
    const Maps from = triangle(.5, .5, .5), to = triangle(.65, .3, .4);
    const CoupledSystem system = coupled(from, to), back = coupled(to, from);
    const Camera camera = cameraOf(from, 128, 128);
    const ifs::FractalTransformation inverse(attractorOf(to), from);
    for (const Points& points : {exact(system, camera), sampled(system, camera, 3'000'000)}) {
        int filled = 0;
        for (std::size_t k = 0; k < points.size(); k += 7) {
            if (points[k].isEmpty()) continue;
            const auto there = inverse.at({points[k].x, points[k].y});
            QVERIFY(there.image);
            const Vector<2> off =
                toPixel(camera, *there.image) - Vector<2>(double(k % 128) + .5, double(k / 128) + .5);
            QVERIFY(off.norm() <= 2);
            ++filled;
        }
        QVERIFY(filled > 500);
    }
}

void TopsTest::reversedOrderDiffersOnTheOverlap() {
    const Maps maps = overlappingInterval();
    const Camera camera{{.5, 0}, 300, 300, 1, attractor::YAxis::Up};
    const Points upper = exact(coupled(maps, maps), camera);
    const Points lower = exact(coupled(reversed(maps), reversed(maps)), camera);
    for (int k = 0; k < 300; ++k) {
        const bool upperIsFirst = upper[std::size_t(k)].address < .5;
        const bool lowerIsFirst = lower[std::size_t(k)].address >= .5;
        if (k % 100 != 0 && k % 100 != 99) QCOMPARE(upperIsFirst != lowerIsFirst, k > 100 && k < 200);
    }
}

void TopsTest::everyPictureIsTheSame_data() {
    QTest::addColumn<bool>("isExact");
    QTest::newRow("exact") << true;
    QTest::newRow("samples") << false;
}

namespace {

attractor::MipPicture gradient(int width, int height) {
    std::vector<attractor::Rgba> pixels;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            pixels.push_back({std::uint8_t(255 * x / width), std::uint8_t(255 * y / height),
                              std::uint8_t((x / 8 + y / 8) % 2 ? 255 : 0), std::uint8_t(x % 5 ? 255 : 90)});
    return {width, height, pixels};
}

std::vector<std::uint32_t> stolen(const CoupledSystem& system, const attractor::MipPicture& picture,
                                  const attractor::TheftRequest& request) {
    std::vector<std::uint32_t> result;
    const auto take = [&](std::span<const std::uint32_t> pixels) {
        result.insert(result.end(), pixels.begin(), pixels.end());
        return true;
    };
    if (attractor::steal(system, picture, request, take, {}) != attractor::TheftOutcome::Done) return {};
    return result;
}

} // namespace

// Whatever the threads and the instruction set.
void TopsTest::everyPictureIsTheSame() {
    QFETCH(bool, isExact);
    const Maps from = canonical::fern(), to = canonical::maple();
    const CoupledSystem system = coupled(from, to);
    attractor::TheftRequest request;
    request.camera = cameraOf(from, 310, 230);
    request.toPicture = worldToPixel(cameraOf(to, 64, 48));
    request.isExact = isExact;
    request.points = 2'000'000;
    const auto picture = gradient(64, 48);
    const auto expected = stolen(system, picture, request);
    QCOMPARE(expected.size(), std::size_t(310 * 230));
    QVERIFY(std::ranges::count(expected, expected.front()) < 310 * 220); // not all is background
    for (const std::string& set : attractor::simdNames())
        for (const int threads : {1, 2, 7}) {
            QVERIFY(attractor::selectSimd(set));
            request.threads = threads;
            QVERIFY2(stolen(system, picture, request) == expected, set.c_str());
        }
    request.seed = 2;
    QCOMPARE(stolen(system, picture, request) == expected, isExact);
}

void TopsTest::identityCopiesThePicture() {
    const Maps maps = square(.5, .5);
    attractor::TheftRequest request;
    request.camera = {{.5, .5}, 64, 64, 64, attractor::YAxis::Up};
    request.toPicture = worldToPixel(request.camera);
    request.isExact = true;
    std::vector<attractor::Rgba> pixels;
    for (int k = 0; k < 64 * 64; ++k)
        pixels.push_back({std::uint8_t(k % 64 * 4), std::uint8_t(k / 64 * 4), 128, 255});
    const attractor::MipPicture picture(64, 64, pixels);
    const auto result = stolen(coupled(maps, maps), picture, request);
    for (std::size_t k = 0; k < result.size(); ++k) {
        const auto channel = [&](int shift) { return int(result[k] >> shift & 255); };
        QVERIFY(std::abs(channel(16) - pixels[k].red) <= 4); // a pixel
        QVERIFY(std::abs(channel(8) - pixels[k].green) <= 4);
        QCOMPARE(channel(0), 128);
    }
}

void TopsTest::conjugacyMovesThePicture_data() {
    everyPictureIsTheSame_data();
}

// G = MFM⁻¹, so T is M: the unit square turned onto [1, 3] × [1, 2]. A pixel has the colour of the picture at
// M of it.
void TopsTest::conjugacyMovesThePicture() {
    QFETCH(bool, isExact);
    const Maps from = square(.5, .5);
    const ifs::AffineMap<2> change = ifs::affineMap(0, -2, 1, 0, 3, 1);
    QVERIFY(change({1, 0}) == Vector<2>(3, 2));
    Maps to;
    for (const auto& map : from)
        to.push_back(*ifs::conjugate<2>(change, map));
    attractor::TheftRequest request;
    request.camera = {{.5, .5}, 64, 64, 64, attractor::YAxis::Up};
    request.toPicture = ifs::affineMap(32, 0, 0, -64, -32, 128); // the box of G to 64 × 64 pixels
    request.isExact = isExact;
    request.points = 3'000'000;
    std::vector<attractor::Rgba> colours;
    for (int k = 0; k < 64 * 64; ++k)
        colours.push_back({std::uint8_t(k % 64 * 4), std::uint8_t(k / 64 * 4), 128, 255});
    const auto result = stolen(coupled(from, to), {64, 64, colours}, request);
    QCOMPARE(result.size(), std::size_t(64 * 64));
    for (int row = 1; row < 63; ++row)
        for (int column = 1; column < 63; ++column) {
            const std::uint32_t pixel = result[std::size_t(64 * row + column)];
            QVERIFY(std::abs(int(pixel >> 16 & 255) - 4 * row) <= 5); // a pixel
            QVERIFY(std::abs(int(pixel >> 8 & 255) - 4 * (63 - column)) <= 5);
            QCOMPARE(int(pixel & 255), 128);
        }
    const CoupledSystem system = coupled(from, to);
    const Points points =
        isExact ? exact(system, request.camera) : sampled(system, request.camera, request.points);
    QCOMPARE(points.size(), std::size_t(64 * 64));
    int filled = 0;
    for (const TopPoint& point : points) {
        QVERIFY(point.isEmpty() || std::abs(point.stretch - 2) < 1e-6); // |det M|
        filled += point.isEmpty() ? 0 : 1;
    }
    QVERIFY(filled >= 62 * 62);
}

// T(x, y) = (h(x), h(y)) takes every pixel into a rectangle of its own.
void TopsTest::pixelsOfSquaresShowTheTransformation() {
    constexpr int side = 48;
    const CoupledSystem system = coupled(square(.5, .5), square(.3, 1.0 / 3));
    const Camera camera{{.5, .5}, side, side, side, attractor::YAxis::Up};
    const auto holds = [](double alpha, int pixel, double image) {
        constexpr double rounding = 0.01; // pixels, of single precision
        return image >= hFunction(alpha, (pixel - rounding) / side) - 1e-9 &&
               image <= hFunction(alpha, (pixel + 1 + rounding) / side) + 1e-9;
    };
    const Points points = sampled(system, camera, 3'000'000);
    QCOMPARE(points.size(), std::size_t(side * side));
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const TopPoint& point = points[std::size_t(side * row + column)];
            QVERIFY(!point.isEmpty());
            QVERIFY(holds(.3, column, point.x));
            QVERIFY(holds(1.0 / 3, side - 1 - row, point.y));
        }
}

void TopsTest::hostileSystems_data() {
    QTest::addColumn<Maps>("maps");
    QTest::newRow("a point") << Maps{onLine(.5, 1), onLine(.25, 1.5)};
    QTest::newRow("constant maps") << Maps{onLine(0, 0), onLine(0, 1)};
    QTest::newRow("one map") << Maps{onLine(.5, 1)};
    QTest::newRow("a thousand on each other") << Maps(1000, onLine(.97, .03));
    QTest::newRow("hardly contracts") << Maps{onLine(.999, 0), onLine(.999, .001)};
    QTest::newRow("stretches") << canonical::eventual();
    QTest::newRow("far away") << Maps{ifs::affineMap(.5, 0, 0, .5, 1e12, 1e12),
                                      ifs::affineMap(.5, 0, 0, .5, 1e12 + 1, 1e12)};
}

void TopsTest::hostileSystems() {
    QFETCH(Maps, maps);
    const CoupledSystem system(attractorOf(maps), attractorOf(maps), equalWeights(maps));
    const Camera camera = cameraOf(maps, 40, 30);
    for (const Points& points : {exact(system, camera), sampled(system, camera, 100'000)}) {
        QCOMPARE(points.size(), std::size_t(40 * 30));
        QVERIFY(std::ranges::any_of(points, [](const TopPoint& p) { return !p.isEmpty(); }));
        for (const TopPoint& point : points)
            QVERIFY(std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.stretch));
    }
}

void TopsTest::stops() {
    const Maps maps = canonical::maple();
    const CoupledSystem system = coupled(maps, maps);
    std::stop_source stop;
    stop.request_stop();
    attractor::TheftRequest request;
    request.camera = cameraOf(maps, 600, 400);
    request.toPicture = worldToPixel(request.camera);
    const auto refuse = [](std::span<const std::uint32_t>) { return false; };
    for (const bool isExact : {true, false}) {
        request.isExact = isExact;
        QCOMPARE(attractor::steal(system, gradient(8, 8), request, refuse, stop.get_token()),
                 attractor::TheftOutcome::Stopped);
        request.points = 1000;
        QCOMPARE(attractor::steal(system, gradient(8, 8), request, refuse, {}),
                 attractor::TheftOutcome::NotTaken);
    }
}

BARYCAGE_TEST(TopsTest);
#include "tops_test.moc"
