// SPDX-License-Identifier: MIT
#include "attractor/request/camera.h"

#include <QtTest>

#include <random>

using namespace attractor;

namespace {

bool near(const ifs::Vector<2>& a, const ifs::Vector<2>& b, double tolerance = 1e-9) {
    return (a - b).cwiseAbs().maxCoeff() < tolerance;
}

Camera random(std::mt19937& generator) {
    std::uniform_real_distribution<double> position(-5, 5);
    std::uniform_real_distribution<double> height(0.1, 20);
    const YAxis axis = generator() % 2 == 0 ? YAxis::Up : YAxis::Down;
    return cameraOf({{position(generator), position(generator)}, height(generator), axis},
                    {int(generator() % 900) + 1, int(generator() % 900) + 1});
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
            QVERIFY(near(toPixel(panned(camera, delta), world), pixel + delta));
        }
    }
};

QTEST_APPLESS_MAIN(TestCamera)
#include "camera_test.moc"
