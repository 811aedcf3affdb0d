// SPDX-License-Identifier: MIT
#include "attractor/request/camera.h"

#include "support/named_test.h"
#include "support/near.h"

#include <QtTest>

#include <cmath>
#include <numbers>
#include <random>

using namespace attractor;
using support::near;

namespace {

Camera random(std::mt19937& generator) {
    std::uniform_real_distribution<double> position(-5, 5);
    std::uniform_real_distribution<double> height(0.1, 20);
    const YAxis axis = generator() % 2 == 0 ? YAxis::Up : YAxis::Down;
    const double rotation = generator() % 4 == 0 ? 0 : rotationOf(position(generator) * 36);
    return cameraOf({{position(generator), position(generator)}, height(generator), axis, rotation},
                    {int(generator() % 900) + 1, int(generator() % 900) + 1});
}

// As before there was a rotation.
ifs::Vector<2> plainPixel(const Camera& camera, const ifs::Vector<2>& world) {
    const ifs::Vector<2> offset = (world - camera.centre) * camera.pixelsPerUnit;
    const double down = camera.yAxis == YAxis::Up ? -1 : 1;
    return ifs::Vector<2>(camera.width / 2.0, camera.height / 2.0) +
           ifs::Vector<2>(offset.x(), down * offset.y());
}

} // namespace

class TestCamera : public QObject {
    Q_OBJECT

private slots:
    // The height of a view fills the raster from the lower edge to the upper one, whatever its size.
    void aViewFillsTheHeight() {
        for (const YAxis axis : {YAxis::Up, YAxis::Down})
            for (const RasterSize size : {RasterSize{640, 480}, RasterSize{30, 2000}, RasterSize{1, 1}}) {
                const Camera camera = cameraOf({{3, -2}, 5, axis}, size);
                const double up = axis == YAxis::Up ? 1 : -1;
                QCOMPARE(camera.width, size.width);
                QCOMPARE(camera.height, size.height);
                QVERIFY(near(toWorld(camera, {size.width / 2.0, 0}), {3, -2 + up * 2.5}));
                QVERIFY(near(toWorld(camera, {size.width / 2.0, double(size.height)}), {3, -2 - up * 2.5}));
                QVERIFY(near(toPixel(camera, {3, -2}), {size.width / 2.0, size.height / 2.0}));
            }
    }

    void pixelsAndWorldAreInverse() {
        std::mt19937 generator(31);
        for (int n = 0; n < 1000; ++n) {
            const Camera camera = random(generator);
            const ifs::Vector<2> pixel(generator() % 1000 / 3.0, generator() % 1000 / 7.0);
            const ifs::Vector<2> world = toWorld(camera, pixel);
            QVERIFY(near(toPixel(camera, world), pixel));
            QVERIFY(near(worldToPixel(camera)(world), pixel));
        }
    }

    void aBoxFitsWithItsMargin() {
        const Camera camera = fitted(cameraOf({}, {400, 100}), {-1, 2}, {3, 4}, 0.1);
        QVERIFY(near(camera.centre, {1, 3}));
        QVERIFY(near(toPixel(camera, {1, 4}), {200, 10})); // the height is what binds
        QVERIFY(near(toPixel(camera, {1, 2}), {200, 90}));
        const Camera wide = fitted(cameraOf({}, {100, 400}), {-1, 2}, {3, 4}, 0.1);
        QVERIFY(near(toPixel(wide, {-1, 3}), {10, 200}));
        const Camera point = fitted(cameraOf({{0, 0}, 5, YAxis::Up}, {400, 100}), {7, 7}, {7, 7});
        QVERIFY(near(point.centre, {7, 7}));
        QCOMPARE(point.pixelsPerUnit, 20.0);
    }

    void zoomAndPanKeepWhatIsHeld() {
        std::mt19937 generator(32);
        for (int n = 0; n < 1000; ++n) {
            const Camera camera = random(generator);
            const ifs::Vector<2> pixel(generator() % 1000 / 3.0, generator() % 1000 / 7.0);
            const ifs::Vector<2> world = toWorld(camera, pixel);
            const Camera zoomed = zoomedAt(camera, pixel, 2.5);
            QVERIFY(near(toPixel(zoomed, world), pixel, 1e-8));
            QVERIFY(std::abs(zoomed.pixelsPerUnit / camera.pixelsPerUnit - 2.5) < 1e-12);
            const ifs::Vector<2> delta(13, -7);
            QVERIFY(near(toPixel(panned(camera, delta), world), ifs::Vector<2>(pixel + delta)));
            const Camera turned = rotatedAt(camera, pixel, 0.7);
            QVERIFY(near(toPixel(turned, world), pixel, 1e-8));
            QVERIFY(std::abs(std::remainder(turned.rotation - camera.rotation - 0.7, 2 * std::numbers::pi)) <
                    2e-8);
            QCOMPARE(turned.pixelsPerUnit, camera.pixelsPerUnit);
        }
    }

    void withoutRotationNothingIsOther() {
        std::mt19937 generator(33);
        for (int n = 0; n < 1000; ++n) {
            Camera camera = random(generator);
            camera.rotation = 0;
            const ifs::Vector<2> world(generator() % 1000 / 3.0, generator() % 1000 / 7.0);
            QCOMPARE(toPixel(camera, world), plainPixel(camera, world));
            const ifs::AffineMap<2> map = worldToPixel(camera);
            QCOMPARE(map.linear(0, 0), camera.pixelsPerUnit);
            QCOMPARE(map.linear(0, 1), 0.0);
            const ifs::Vector<2> middle = camera.centre;
            QCOMPARE(rotatedAt(camera, {camera.width / 2.0, camera.height / 2.0}, 1).centre, middle);
        }
    }

    // A positive rotation turns the picture counter-clockwise on the screen, whichever way y points.
    void theRotationIsSeenCounterClockwise() {
        for (const YAxis axis : {YAxis::Up, YAxis::Down}) {
            const Camera camera = cameraOf({{3, -2}, 5, axis, rotationOf(90)}, {500, 500});
            QVERIFY(near(toPixel(camera, {4, -2}), {250, 150})); // x points upwards
            const double up = axis == YAxis::Up ? 1 : -1;
            QVERIFY(near(toPixel(camera, {3, -2 + up}), {150, 250}));
        }
    }

    void quarterTurnsAreExact() {
        const ifs::Matrix<2> quarter = screenTurn(rotationOf(90));
        QCOMPARE(quarter(0, 0), 0.0);
        QCOMPARE(quarter(0, 1), 1.0);
        QCOMPARE(quarter(1, 0), -1.0);
        QVERIFY(screenTurn(rotationOf(180)) == -ifs::Matrix<2>::Identity());
        QVERIFY(screenTurn(rotationOf(-90)) == quarter.transpose());
        QVERIFY(screenTurn(0) == ifs::Matrix<2>::Identity());
        for (const double angle : {0.1, 1.0, 2.0, 3.0, -0.5, -2.5, 4.0, 9.0}) {
            ifs::Matrix<2> turn;
            turn << std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle);
            QVERIFY((screenTurn(angle) - turn).cwiseAbs().maxCoeff() < 1e-15 * 10);
        }
    }

    void degreesComeBack() {
        QCOMPARE(degreesOf(rotationOf(30)), 30.0);
        QCOMPARE(degreesOf(rotationOf(-180)), 180.0);
        QCOMPARE(degreesOf(rotationOf(540)), 180.0);
        QCOMPARE(degreesOf(rotationOf(-375)), -15.0);
        QCOMPARE(rotationOf(360), 0.0);
        std::mt19937 generator(34);
        std::uniform_real_distribution<double> angle(-400, 400);
        for (int n = 0; n < 10'000; ++n) {
            const double rotation = rotationOf(angle(generator));
            QCOMPARE(rotationOf(degreesOf(rotation)), rotation);
        }
        Camera camera = cameraOf({}, {10, 10});
        for (int n = 0; n < 24; ++n)
            camera = rotatedAt(camera, {5, 5}, std::numbers::pi / 12);
        QCOMPARE(camera.rotation, 0.0); // once round
    }

    void aTurnedBoxFitsWithItsMargin() {
        std::mt19937 generator(35);
        for (int n = 0; n < 1000; ++n) {
            const Camera before = random(generator);
            const ifs::Vector<2> min(-1, 2), max(3, 4);
            const Camera camera = fitted(before, min, max, 0.1);
            QCOMPARE(camera.rotation, before.rotation);
            double nearest = 1; // to an edge, as a share of the picture
            for (const ifs::Vector<2>& corner : {min, max, {min.x(), max.y()}, {max.x(), min.y()}}) {
                const ifs::Vector<2> pixel = toPixel(camera, corner);
                for (const double share : {pixel.x() / camera.width, pixel.y() / camera.height})
                    nearest = std::min({nearest, share, 1 - share});
            }
            QVERIFY(std::abs(nearest - 0.1) < 1e-9); // no corner is nearer, and one is as near
        }
    }

    void viewsAndCamerasAreTheSame() {
        const View view{{3, -2}, 5, YAxis::Down, rotationOf(33)};
        QVERIFY(viewOf(cameraOf(view, {512, 256})) == view);
    }
};

BARYCAGE_TEST(TestCamera);
#include "camera_test.moc"
