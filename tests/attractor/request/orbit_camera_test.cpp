// SPDX-License-Identifier: MIT
#include "attractor/request/orbit_camera.h"
#include "support/named_test.h"

#include <QtTest>

#include <cmath>
#include <random>

using namespace attractor;

namespace {

using ifs::Vector;

// φ = 30°, θ = 20°, the eye 5 away from the origin, 1920 × 1080.
OrbitCamera oracleCamera(OrbitCamera::Projection projection) {
    OrbitCamera camera;
    camera.orientation = orbit(30, 20);
    camera.height = 10 * std::tan(20 * M_PI / 180);
    camera.projection = projection;
    camera.size = {1920, 1080};
    return camera;
}

Orientation randomOrientation(std::mt19937& random) {
    std::uniform_real_distribution<double> u(-180, 180);
    return orbit(u(random), u(random), u(random));
}

ifs::SupportFunction<3> tetrahedron() {
    std::vector<ifs::AffineMap<3>> maps(4);
    for (int i = 0; i < 4; ++i) {
        maps[std::size_t(i)].linear *= 0.5;
        if (i > 0) maps[std::size_t(i)].translation[i - 1] = 0.5;
    }
    return *ifs::SupportFunction<3>::of(maps);
}

} // namespace

class TestOrbitCamera : public QObject {
    Q_OBJECT

private slots:
    void perspectiveOracle_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<double>("z");
        QTest::addColumn<double>("column");
        QTest::addColumn<double>("row");
        QTest::newRow("e1") << 1. << 0. << 0. << 1243.62570422202 << 596.0062693224439;
        QTest::newRow("e2") << 0. << 1. << 0. << 960. << 240.6935320481183;
        QTest::newRow("e3") << 0. << 0. << 1. << 782.7943021416451 << 644.9759936281134;
        QTest::newRow("sum") << 1. << 1. << 1. << 1120.9351140293131 << 332.256677695753;
        QTest::newRow("target") << 0. << 0. << 0. << 960. << 540.;
    }
    void perspectiveOracle() {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(double, z);
        QFETCH(double, column);
        QFETCH(double, row);
        const ScreenPoint seen = toScreen(oracleCamera(OrbitCamera::Projection::Perspective), {x, y, z});
        QVERIFY(std::abs(seen.pixel.x() - column) < 1e-9);
        QVERIFY(std::abs(seen.pixel.y() - row) < 1e-9);
    }

    void orthographicOracle() {
        const OrbitCamera camera = oracleCamera(OrbitCamera::Projection::Orthographic);
        const Vector<2> e1 = toScreen(camera, {1, 0, 0}).pixel;
        QVERIFY((e1 - Vector<2>(1216.9736060897562, 590.7434015224391)).norm() < 1e-9);
        const Vector<2> sum = toScreen(camera, {1, 1, 1}).pixel;
        QVERIFY((sum - Vector<2>(1068.6098254392066, 399.80085136973014)).norm() < 1e-9);
    }

    // Depth counts from the plane of the target; the eye is 5 away from it.
    void depthOracle() {
        for (const auto projection :
             {OrbitCamera::Projection::Orthographic, OrbitCamera::Projection::Perspective}) {
            const OrbitCamera camera = oracleCamera(projection);
            QVERIFY(std::abs(eyeDistance(camera) - 5) < 1e-14);
            QCOMPARE(toScreen(camera, {0, 0, 0}).depth, 0.0);
            QVERIFY(std::abs(5 + toScreen(camera, {1, 0, 0}).depth - 4.5301536896070465) < 1e-14);
        }
    }

    // eye = target + d (cosθ sinφ, sinθ, cosθ cosφ), up never leans.
    void theEyeStandsWhereAnglesSay() {
        const double phi = 30 * M_PI / 180;
        const double theta = 20 * M_PI / 180;
        const ifs::Matrix<3> axes = orbit(30, 20).toRotationMatrix();
        const Vector<3> eye(std::cos(theta) * std::sin(phi), std::sin(theta),
                            std::cos(theta) * std::cos(phi));
        QVERIFY((axes.col(2) - eye).norm() < 1e-15);
        QVERIFY(std::abs(axes(1, 0)) < 1e-15);
        QVERIFY(axes(1, 1) > 0);
        QVERIFY(std::abs(axes.determinant() - 1) < 1e-15);
        // From the front, x to the right; from +x, z to the left; from above, z downwards.
        QCOMPARE(orbit(0, 0).toRotationMatrix(), ifs::Matrix<3>(ifs::Matrix<3>::Identity()));
        QVERIFY((orbit(90, 0).toRotationMatrix().col(0) - Vector<3>(0, 0, -1)).norm() < 1e-15);
        QVERIFY((orbit(0, 90).toRotationMatrix().col(1) - Vector<3>(0, 0, -1)).norm() < 1e-15);
    }

    // Roll turns the camera clockwise, so that the picture turns counter-clockwise.
    void rollTurnsThePictureCounterClockwise() {
        OrbitCamera camera;
        camera.size = {200, 200};
        camera.height = 2;
        camera.orientation = orbit(0, 0, 90);
        const Vector<2> right = toScreen(camera, {1, 0, 0}).pixel; // stood to the right, is at the top now
        QVERIFY((right - Vector<2>(100, 0)).norm() < 1e-12);
    }

    void screenAndWorldAreInverse() {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> u(-1, 1);
        for (int n = 0; n < 1000; ++n) {
            OrbitCamera camera;
            camera.target = {u(random), u(random), u(random)};
            camera.orientation = randomOrientation(random);
            camera.height = 3 + u(random);
            camera.size = {int(random() % 900) + 1, int(random() % 900) + 1};
            camera.projection =
                n % 2 == 0 ? OrbitCamera::Projection::Perspective : OrbitCamera::Projection::Orthographic;
            const Vector<3> x = camera.target + 0.8 * Vector<3>(u(random), u(random), u(random));
            QVERIFY((toWorld(camera, toScreen(camera, x)) - x).norm() < 1e-12);
        }
    }

    void behindTheEyeThereIsNoPixel() {
        const OrbitCamera camera = oracleCamera(OrbitCamera::Projection::Perspective);
        const Vector<3> eye = 5 * camera.orientation.toRotationMatrix().col(2);
        QVERIFY(!std::isfinite(toScreen(camera, eye * 1.5 + Vector<3>(0.1, 0.1, 0.1)).pixel.x()));
    }

    // The silhouette stays within the margin and touches it, under every camera.
    void fitsTheSilhouette() {
        const ifs::SupportFunction<3> support = tetrahedron();
        const std::vector<Vector<3>> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        ifs::AffineMap<3> cage;
        cage.linear << 1, 0.5, 0, 0, 2, 0, 0.3, 0, 1;
        cage.translation = {4, -2, 1};
        std::mt19937 random(11);
        for (int n = 0; n < 200; ++n) {
            OrbitCamera camera;
            camera.orientation = randomOrientation(random);
            camera.size = {300 + int(random() % 700), 300 + int(random() % 700)};
            camera.projection =
                n % 2 == 0 ? OrbitCamera::Projection::Perspective : OrbitCamera::Projection::Orthographic;
            const double margin = 0.05 * (n % 3);
            camera = fitted(camera, support, cage, margin);
            double least = HUGE_VAL; // distance from the border, as a share of the picture
            for (const Vector<3>& corner : corners) {
                const Vector<2> at = toScreen(camera, cage(corner)).pixel;
                least = std::min({least, at.x() / camera.size.width, 1 - at.x() / camera.size.width,
                                  at.y() / camera.size.height, 1 - at.y() / camera.size.height});
            }
            QVERIFY(least >= margin - 1e-12);
            QVERIFY(least < margin + 2e-3);
        }
    }

    void aPointKeepsItsScale() {
        OrbitCamera camera;
        camera.size = {100, 100};
        camera.height = 3;
        for (const auto projection :
             {OrbitCamera::Projection::Orthographic, OrbitCamera::Projection::Perspective}) {
            camera.projection = projection;
            const OrbitCamera shown = fitted(camera, {1, 2, 3}, {1, 2, 3});
            QCOMPARE(shown.height, 3.0);
            QVERIFY((shown.target - Vector<3>(1, 2, 3)).norm() < 1e-12);
        }
    }

    void badCamerasAreKnown() {
        OrbitCamera camera;
        QVERIFY(!isUsable(camera)); // no raster
        camera.size = {10, 10};
        QVERIFY(isUsable(camera));
        for (const double height : {0.0, -1.0, double(NAN), HUGE_VAL, 1e-320}) {
            OrbitCamera bad = camera;
            bad.height = height;
            QVERIFY(!isUsable(bad));
        }
        OrbitCamera bad = camera;
        bad.fieldOfView = 180;
        QVERIFY(!isUsable(bad));
        bad = camera;
        bad.target.x() = NAN;
        QVERIFY(!isUsable(bad));
        bad = camera;
        bad.orientation.w() = NAN;
        QVERIFY(!isUsable(bad));
    }
};

BARYCAGE_TEST(TestOrbitCamera);
#include "orbit_camera_test.moc"
