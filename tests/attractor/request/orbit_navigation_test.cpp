// SPDX-License-Identifier: MIT
#include "attractor/request/orbit_navigation.h"

#include <QtTest>

#include <random>

using namespace attractor;

namespace {

OrbitCamera cameraOf(OrbitCamera::Projection projection, std::mt19937& random) {
    std::uniform_real_distribution<double> u(-1, 1);
    OrbitCamera camera;
    camera.projection = projection;
    camera.size.width = 640;
    camera.size.height = 480;
    camera.height = 2 + u(random);
    camera.target = {u(random), u(random), u(random)};
    camera.orientation = orbit(180 * u(random), 80 * u(random), 30 * u(random));
    return camera;
}

double distance(const ifs::Vector<2>& a, const ifs::Vector<2>& b) {
    return (a - b).norm();
}

constexpr auto both = {OrbitCamera::Projection::Orthographic, OrbitCamera::Projection::Perspective};

} // namespace

class OrbitNavigationTest : public QObject {
    Q_OBJECT

private slots:
    void thePivotStaysAtItsPixel();
    void aTurntableKeepsTheHorizon();
    void elevationEndsAtThePole();
    void panningMovesThePlaneOfTheTarget();
    void zoomingKeepsWhatIsUnderThePointer();
    void aCentredPointIsInTheMiddle();
    void aRayMeetsWhatIsSeenThere();
};

void OrbitNavigationTest::thePivotStaysAtItsPixel() {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> u(-1, 1);
    for (const auto projection : both)
        for (int n = 0; n < 100; ++n) {
            const OrbitCamera camera = cameraOf(projection, random);
            const ifs::Vector<3> pivot =
                camera.target + 0.5 * ifs::Vector<3>(u(random), u(random), u(random));
            const OrbitCamera turned = orbited(camera, pivot, 90 * u(random), 90 * u(random));
            QVERIFY(distance(toScreen(camera, pivot).pixel, toScreen(turned, pivot).pixel) < 1e-9);
            QVERIFY(std::abs(toScreen(camera, pivot).depth - toScreen(turned, pivot).depth) < 1e-12);
        }
}

void OrbitNavigationTest::aTurntableKeepsTheHorizon() {
    OrbitCamera camera = turnedTo({}, 30, 20);
    camera = orbited(camera, {1, 2, 3}, 47, -31);
    const ifs::Matrix<3> axes = camera.orientation.toRotationMatrix();
    QVERIFY(std::abs(axes.col(0).y()) < 1e-15); // what is to the right is level
    const Orientation same = orbit(77, -11);
    QVERIFY(std::abs(std::abs(camera.orientation.dot(same)) - 1) < 1e-14);
}

void OrbitNavigationTest::elevationEndsAtThePole() {
    const OrbitCamera top = orbited(turnedTo({}, 30, 20), ifs::Vector<3>::Zero(), 0, 500);
    QVERIFY((top.orientation.toRotationMatrix().col(2) - ifs::Vector<3>::UnitY()).norm() < 1e-7);
    const OrbitCamera below = orbited(top, ifs::Vector<3>::Zero(), 0, -500);
    QVERIFY((below.orientation.toRotationMatrix().col(2) + ifs::Vector<3>::UnitY()).norm() < 1e-7);
}

void OrbitNavigationTest::panningMovesThePlaneOfTheTarget() {
    std::mt19937 random(2);
    for (const auto projection : both) {
        const OrbitCamera camera = cameraOf(projection, random);
        const ifs::Vector<2> pixel(100, 200);
        const ifs::Vector<2> delta(33, -21);
        const ifs::Vector<3> seen = toWorld(camera, {pixel, 0});
        QVERIFY(distance(toScreen(panned(camera, delta), seen).pixel, pixel + delta) < 1e-9);
    }
}

void OrbitNavigationTest::zoomingKeepsWhatIsUnderThePointer() {
    std::mt19937 random(3);
    for (const auto projection : both)
        for (const double factor : {0.1, 1.25, 1000.0}) {
            const OrbitCamera camera = cameraOf(projection, random);
            const ifs::Vector<2> pixel(500, 40);
            const ifs::Vector<3> seen = toWorld(camera, {pixel, 0});
            const OrbitCamera zoomed = zoomedAt(camera, pixel, factor);
            QCOMPARE(zoomed.height, camera.height / factor);
            QVERIFY(distance(toScreen(zoomed, seen).pixel, pixel) < 1e-8);
        }
    // Nothing is left of a camera whose height has underflowed: it stays as it is.
    OrbitCamera camera = cameraOf(OrbitCamera::Projection::Orthographic, random);
    QVERIFY(zoomedAt(camera, {0, 0}, HUGE_VAL) == camera);
}

void OrbitNavigationTest::aCentredPointIsInTheMiddle() {
    std::mt19937 random(4);
    for (const auto projection : both) {
        const OrbitCamera camera = cameraOf(projection, random);
        const ifs::Vector<3> point = camera.target + ifs::Vector<3>(0.1, 0.2, -0.1);
        const OrbitCamera centred = centredOn(camera, point);
        QVERIFY(distance(toScreen(centred, point).pixel, {320, 240}) < 1e-9);
        QVERIFY(std::abs(toScreen(centred, point).depth) < 1e-12);
        // Its neighbours are as large as before.
        const ifs::Vector<3> beside = 1e-3 * camera.orientation.toRotationMatrix().col(0);
        const auto size = [&](const OrbitCamera& c) {
            return distance(toScreen(c, point + beside).pixel, toScreen(c, point - beside).pixel);
        };
        QVERIFY(std::abs(size(centred) / size(camera) - 1) < 1e-9);
    }
}

void OrbitNavigationTest::aRayMeetsWhatIsSeenThere() {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> u(-0.5, 0.5);
    for (const auto projection : both)
        for (int n = 0; n < 50; ++n) {
            const OrbitCamera camera = cameraOf(projection, random);
            const ifs::Vector<3> point = camera.target + ifs::Vector<3>(u(random), u(random), u(random));
            const Ray ray = rayThrough(camera, toScreen(camera, point).pixel);
            QVERIFY(std::abs(ray.direction.norm() - 1) < 1e-14);
            QVERIFY((point - ray.origin).cross(ray.direction).norm() < 1e-12);
        }
}

QTEST_GUILESS_MAIN(OrbitNavigationTest)
#include "orbit_navigation_test.moc"
