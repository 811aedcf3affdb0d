// SPDX-License-Identifier: MIT
#include "attractor/render/banded_rendering.h"
#include "attractor/render/renderer.h"
#include "attractor/systems.h"
#include "support/named_test.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace attractor;

namespace {

constexpr int side = 240;

RenderRequest requestOf(Algorithm algorithm, double degrees, bool bends) {
    RenderRequest request;
    request.system = systems::maple();
    request.camera =
        fitted(cameraOf({{}, 1, YAxis::Up, rotationOf(degrees)}, {side, side}), {-4, -1}, {4, 7});
    request.algorithm = algorithm;
    request.samples = 3'000'000;
    if (algorithm != Algorithm::Density || bends) {
        ifs::ControlCage<2> cage;
        cage.rest = cage.current = {{-5, -2}, {5, -2}, {5, 8}, {-5, 8}};
        if (bends) cage.current[2] = {3.5, 7};
        request.cage = cage;
    }
    if (algorithm == Algorithm::Deterministic) request.iterations = 5;
    return request;
}

// Where a pixel of the upright picture is in one that is turned counter-clockwise by quarters.
std::size_t turnedIndex(int x, int y, int quarters) {
    for (int k = 0; k < quarters; ++k) {
        const int up = x;
        x = y;
        y = side - 1 - up;
    }
    return std::size_t(y) * side + std::size_t(x);
}

// The share of pixels that are farther apart than the tones of single samples.
double differing(const Frame& upright, const Frame& turned, int quarters) {
    int count = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const int a = systems::grey(upright.pixels[std::size_t(y) * side + std::size_t(x)]);
            const int b = systems::grey(turned.pixels[turnedIndex(x, y, quarters)]);
            count += std::abs(a - b) > 6;
        }
    return count / double(side * side);
}

int lit(const Frame& frame) {
    return int(std::ranges::count_if(frame.pixels, [&](std::uint32_t p) { return p != frame.pixels[0]; }));
}

} // namespace

// The engine under a camera that is turned.
class RotatedViewTest : public QObject {
    Q_OBJECT

private slots:
    void aQuarterTurnIsThePictureTurned_data() {
        QTest::addColumn<Algorithm>("algorithm");
        QTest::addColumn<bool>("bends");
        QTest::newRow("density") << Algorithm::Density << false;
        QTest::newRow("bent density") << Algorithm::Density << true;
        QTest::newRow("chaos game") << Algorithm::ChaosGame << false;
        QTest::newRow("bent chaos game") << Algorithm::ChaosGame << true;
        QTest::newRow("deterministic") << Algorithm::Deterministic << false;
        QTest::newRow("bent deterministic") << Algorithm::Deterministic << true;
    }

    // The same words and samples fall into the same cells, but for those at the border of two: rounding and
    // the order of a cell's ends are not symmetric there.
    void aQuarterTurnIsThePictureTurned() {
        QFETCH(Algorithm, algorithm);
        QFETCH(bool, bends);
        const Frame upright = render(requestOf(algorithm, 0, bends));
        QVERIFY(lit(upright) > side * side / 10);
        for (const int quarters : {1, 2, 3}) {
            const Frame turned = render(requestOf(algorithm, 90.0 * quarters, bends));
            const double share = differing(upright, turned, quarters);
            QVERIFY2(share < 0.003, qPrintable(QString::number(share)));
        }
    }

    // Any angle: each sample is where the camera says.
    void samplesFallWhereTheCameraSays() {
        for (const double degrees : {30.0, -75.0, 141.0}) {
            RenderRequest request = requestOf(Algorithm::Density, degrees, false);
            ifs::IteratedFunctionSystem<2> point;
            ifs::append<2>(point, ifs::affineMap(0.5, 0, 0, 0.5, 1.1, 2.3), std::nullopt);
            request.system = point;
            const Frame frame = render(request);
            const ifs::Vector<2> at = toPixel(request.camera, {2.2, 4.6});
            QVERIFY(frame.pixels[std::size_t(at.y()) * side + std::size_t(at.x())] != frame.pixels[0]);
            QVERIFY(lit(frame) <= 2);
        }
    }

    // Deep inside, where offsets from the camera need twice the digits.
    void depthIsSeenTurned() {
        RenderRequest upright = requestOf(Algorithm::Density, 0, false);
        upright.system = systems::sierpinski();
        upright.camera.centre = {1.0 / 3, 2.0 / 3}; // on the long edge
        upright.camera.pixelsPerUnit = 1e11;
        RenderRequest turned = upright;
        turned.camera.rotation = rotationOf(90);
        const Frame before = render(upright), after = render(turned);
        QVERIFY(lit(before) > side);
        QVERIFY(differing(before, after, 1) < 0.01);
    }

    void bandsAreThoseOfTheWholePicture() {
        RenderRequest request = requestOf(Algorithm::Density, 37, false);
        BandedRendering rendering(request);
        std::vector<std::uint32_t> pixels(std::size_t(side) * side);
        QVERIFY(rendering.band(0, side / 2, std::span(pixels).first(pixels.size() / 2)));
        QVERIFY(rendering.band(side / 2, side / 2, std::span(pixels).last(pixels.size() / 2)));
        BandedRendering again(request);
        std::vector<std::uint32_t> whole(pixels.size());
        QVERIFY(again.band(0, side, whole));
        int far = 0;
        for (std::size_t k = 0; k < pixels.size(); ++k)
            far += std::abs(systems::grey(pixels[k]) - systems::grey(whole[k])) > 12;
        QVERIFY2(far < side * side / 100, qPrintable(QString::number(far)));
    }

    void aRotationThatIsNoNumberDrawsNothing() {
        RenderRequest request = requestOf(Algorithm::Density, 0, false);
        request.camera.rotation = std::nan("");
        QCOMPARE(lit(render(request)), 0);
    }
};

BARYCAGE_TEST(RotatedViewTest);
#include "rotated_view_test.moc"
