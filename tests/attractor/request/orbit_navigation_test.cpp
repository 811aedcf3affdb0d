// SPDX-License-Identifier: MIT
#include "attractor/request/orbit_navigation.h"
#include "support/named_test.h"

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
    void zUpStandsLikeYUp();
    void aTrackballTurnsAboutTheScreen();
    void directionsAreRead();
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

// The same turns of a world that stands on its side show the same.
void OrbitNavigationTest::zUpStandsLikeYUp() {
    const ifs::Vector<3> pivot(0.3, 0.2, -0.4), point(0.5, -0.7, 0.1);
    const Orientation stand = standing(UpAxis::Z);
    QVERIFY((stand * ifs::Vector<3>(0, 1, 0) - ifs::Vector<3>(0, 0, 1)).norm() < 1e-15);
    OrbitCamera yUp = turnedTo({}, 30, 20), zUp = turnedTo({}, 30, 20, UpAxis::Z);
    for (OrbitCamera* camera : {&yUp, &zUp})
        camera->size = {640, 480};
    for (int n = 0; n < 5; ++n) {
        QVERIFY(distance(toScreen(yUp, point).pixel, toScreen(zUp, stand * point).pixel) < 1e-9);
        yUp = orbited(yUp, pivot, 31, 25);
        zUp = orbited(zUp, stand * pivot, 31, 25, UpAxis::Z);
    }
    const ifs::Matrix<3> front = turnedTo({}, 0, 0, UpAxis::Z).orientation.toRotationMatrix();
    QVERIFY((front.col(2) - ifs::Vector<3>(0, -1, 0)).norm() < 1e-15); // from −y, with x to the right
    QVERIFY((front.col(0) - ifs::Vector<3>(1, 0, 0)).norm() < 1e-15);
    const OrbitCamera again = stoodUp(stoodUp(yUp, UpAxis::Y, UpAxis::Z), UpAxis::Z, UpAxis::Y);
    QVERIFY(again.orientation.angularDistance(yUp.orientation) < 1e-7);
}

void OrbitNavigationTest::aTrackballTurnsAboutTheScreen() {
    std::mt19937 random(7);
    for (const auto projection : both) {
        const OrbitCamera camera = cameraOf(projection, random);
        const ifs::Vector<3> pivot = camera.target + ifs::Vector<3>(0.1, -0.2, 0.15);
        const OrbitCamera over = tumbled(camera, pivot, 0, 250); // past the pole
        QVERIFY(distance(toScreen(camera, pivot).pixel, toScreen(over, pivot).pixel) < 1e-9);
        const auto right = [](const OrbitCamera& of) {
            return of.orientation.toRotationMatrix().col(0).eval();
        };
        QVERIFY((right(over) - right(camera)).norm() < 1e-12); // about what is to the right
        const OrbitCamera back = tumbled(tumbled(camera, pivot, 30, 40), pivot, -30, -40);
        QVERIFY((back.target - camera.target).norm() < 1e-12);
        QVERIFY(back.orientation.angularDistance(camera.orientation) < 1e-7);
        QVERIFY(tumbled(camera, pivot, 0, 0) == camera);
    }
    // From a level view straight ahead it does what a turntable does.
    const OrbitCamera level = turnedTo({}, 0, 0);
    QVERIFY(tumbled(level, level.target, 0, 35)
                .orientation.angularDistance(orbited(level, level.target, 0, 35).orientation) < 1e-7);
    QVERIFY(tumbled(level, level.target, 35, 0)
                .orientation.angularDistance(orbited(level, level.target, 35, 0).orientation) < 1e-7);
}

void OrbitNavigationTest::directionsAreRead() {
    for (const UpAxis up : {UpAxis::Y, UpAxis::Z})
        for (const double elevation : {-90.0, -40.0, 0.0, 65.0, 90.0})
            for (const double azimuth : {-170.0, -30.0, 0.0, 120.0}) {
                const Direction read = directionOf(turnedTo({}, azimuth, elevation, up), up);
                QVERIFY(std::abs(read.azimuth - azimuth) < 1e-6);
                QVERIFY(std::abs(read.elevation - elevation) < 1e-6);
            }
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

BARYCAGE_TEST(OrbitNavigationTest, QCoreApplication);
#include "orbit_navigation_test.moc"
