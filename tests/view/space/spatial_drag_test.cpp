// SPDX-License-Identifier: MIT
#include "space/spatial_drag.h"
#include "support/named_test.h"

#include <QtTest>

#include <random>

using attractor::OrbitCamera;
using view::AxisLock;

namespace {

view::SpatialDrag dragFrom(double azimuth, double elevation,
                           OrbitCamera::Projection projection = OrbitCamera::Projection::Orthographic) {
    view::SpatialDrag drag;
    drag.camera.orientation = attractor::orbit(azimuth, elevation);
    drag.camera.projection = projection;
    drag.camera.height = 4;
    drag.camera.size.width = 800;
    drag.camera.size.height = 600;
    drag.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    drag.held = 3;
    drag.press = toScreen(drag.camera, drag.vertices[3]).pixel;
    return drag;
}

constexpr auto both = {OrbitCamera::Projection::Orthographic, OrbitCamera::Projection::Perspective};

} // namespace

class SpatialDragTest : public QObject {
    Q_OBJECT

private slots:
    void nothingMovesWhereItWasPressed();
    void aFreeVertexFollowsThePointerInItsDepth();
    void aLockedVertexStaysOnItsAxis();
    void aVertexInAPlaneFollowsThePointer();
    void anAxisTowardsTheEyeNeverJumps();
    void aPlaneSeenFromItsEdgeNeverJumps();
    void theWheelPushesAlongTheView();
    void allVerticesTurnAndScaleAboutTheirMiddle();
    void aDragFromTheMiddleIsNoLeap();
    void theNearestAxisIsThatOfTheMotion();
};

void SpatialDragTest::nothingMovesWhereItWasPressed() {
    for (const auto projection : both)
        for (const auto mode :
             {view::SpatialDrag::Mode::Move, view::SpatialDrag::Mode::Rotate, view::SpatialDrag::Mode::Scale})
            for (const AxisLock lock :
                 {AxisLock{}, AxisLock{AxisLock::Kind::Axis, 1}, AxisLock{AxisLock::Kind::Plane, 2}}) {
                view::SpatialDrag drag = dragFrom(30, 20, projection);
                drag.mode = mode;
                QVERIFY(view::dragged(drag, {drag.press, 0}, lock) == drag.vertices); // to the bit
            }
}

void SpatialDragTest::aFreeVertexFollowsThePointerInItsDepth() {
    for (const auto projection : both) {
        const view::SpatialDrag drag = dragFrom(30, 20, projection);
        const ifs::Vector<2> pointer = drag.press + ifs::Vector<2>(50, -30);
        const auto moved = view::dragged(drag, {pointer, 0}, {});
        QVERIFY((toScreen(drag.camera, moved[3]).pixel - pointer).norm() < 1e-9);
        QVERIFY(std::abs(toScreen(drag.camera, moved[3]).depth -
                         toScreen(drag.camera, drag.vertices[3]).depth) < 1e-12);
        for (const std::size_t other : {0, 1, 2})
            QVERIFY(moved[other] == drag.vertices[other]);
    }
}

void SpatialDragTest::aLockedVertexStaysOnItsAxis() {
    for (const auto projection : both)
        for (int axis = 0; axis < 3; ++axis) {
            const view::SpatialDrag drag = dragFrom(30, 20, projection);
            const ifs::Vector<3>& start = drag.vertices[3];
            // The pointer moves just along the axis as it is seen: then the vertex is under it.
            const ifs::Vector<3> wanted = start + 0.4 * ifs::Vector<3>::Unit(axis);
            const auto moved =
                view::dragged(drag, {toScreen(drag.camera, wanted).pixel, 0}, {AxisLock::Kind::Axis, axis});
            QVERIFY((moved[3] - wanted).norm() < 1e-9);
            // Wherever the pointer is, two coordinates stay, to the bit.
            const auto far = view::dragged(drag, {{10, 20}, 0}, {AxisLock::Kind::Axis, axis});
            for (int other = 0; other < 3; ++other)
                if (other != axis) QCOMPARE(far[3][other], start[other]);
        }
}

void SpatialDragTest::aVertexInAPlaneFollowsThePointer() {
    for (const auto projection : both)
        for (int axis = 0; axis < 3; ++axis) {
            const view::SpatialDrag drag = dragFrom(30, 20, projection);
            const ifs::Vector<2> pointer = drag.press + ifs::Vector<2>(-40, 25);
            const auto moved = view::dragged(drag, {pointer, 0}, {AxisLock::Kind::Plane, axis});
            QCOMPARE(moved[3][axis], drag.vertices[3][axis]);
            QVERIFY((toScreen(drag.camera, moved[3]).pixel - pointer).norm() < 1e-8);
        }
}

void SpatialDragTest::anAxisTowardsTheEyeNeverJumps() {
    for (const double elevation : {0.0, 0.001, 5.0, 7.9, 8.1, 12.0}) {
        const view::SpatialDrag drag = dragFrom(0, elevation); // the z axis points at the eye, nearly
        ifs::Vector<3> before = drag.vertices[3];
        for (int pixels = 1; pixels < 200; ++pixels) {
            const auto moved =
                view::dragged(drag, {drag.press + ifs::Vector<2>(0, pixels), 0}, {AxisLock::Kind::Axis, 2});
            // A pixel is 1/150 of a unit; at 8°, at most 1/sin 8° of that.
            QVERIFY((moved[3] - before).norm() < 8.0 / 150);
            before = moved[3];
        }
    }
}

void SpatialDragTest::aPlaneSeenFromItsEdgeNeverJumps() {
    for (const double elevation : {0.0, 0.01, 4.0, 7.9}) {
        const view::SpatialDrag drag = dragFrom(20, elevation); // the plane y = 0
        ifs::Vector<3> before = drag.vertices[3];
        for (int pixels = 1; pixels < 200; ++pixels) {
            const auto moved = view::dragged(drag, {drag.press + ifs::Vector<2>(pixels, pixels), 0},
                                             {AxisLock::Kind::Plane, 1});
            QCOMPARE(moved[3].y(), drag.vertices[3].y());
            QVERIFY((moved[3] - before).norm() < 8.0 / 150);
            before = moved[3];
        }
    }
}

void SpatialDragTest::theWheelPushesAlongTheView() {
    const view::SpatialDrag drag = dragFrom(30, 20);
    const auto pushed = view::dragged(drag, {drag.press, 0.25}, {});
    const attractor::ScreenPoint seen = toScreen(drag.camera, pushed[3]);
    QVERIFY((seen.pixel - drag.press).norm() < 1e-9);
    QVERIFY(std::abs(seen.depth - toScreen(drag.camera, drag.vertices[3]).depth - 0.25) < 1e-12);
    const auto bound = view::dragged(drag, {drag.press, 0.25}, {AxisLock::Kind::Axis, 0});
    QVERIFY(bound[3].x() != drag.vertices[3].x());
    QCOMPARE(bound[3].y(), drag.vertices[3].y());
    QCOMPARE(bound[3].z(), drag.vertices[3].z());
}

void SpatialDragTest::allVerticesTurnAndScaleAboutTheirMiddle() {
    view::SpatialDrag drag = dragFrom(0, 0); // x to the right, y up
    const ifs::Vector<3> middle(0.25, 0.25, 0.25);
    const ifs::Vector<2> centre = toScreen(drag.camera, middle).pixel;
    drag.press = centre + ifs::Vector<2>(100, 0);
    drag.mode = view::SpatialDrag::Mode::Rotate;
    const auto turned = view::dragged(drag, {centre + ifs::Vector<2>(0, -50), 0}, {}); // a quarter, upwards
    QVERIFY((turned[1] - (middle + ifs::Vector<3>(0.25, 0.75, -0.25))).norm() < 1e-9);
    drag.mode = view::SpatialDrag::Mode::Scale;
    const auto scaled = view::dragged(drag, {centre + ifs::Vector<2>(200, 0), 0}, {});
    for (std::size_t i = 0; i < 4; ++i)
        QVERIFY((scaled[i] - (middle + 2 * (drag.vertices[i] - middle))).norm() < 1e-9);
}

// As from the handle in the middle of a map.
void SpatialDragTest::aDragFromTheMiddleIsNoLeap() {
    view::SpatialDrag drag = dragFrom(0, 0);
    const ifs::Vector<3> middle(0.25, 0.25, 0.25);
    for (const double beside : {-3.0, 0.0, 3.0, 15.0}) {
        drag.press = toScreen(drag.camera, middle).pixel + ifs::Vector<2>(beside, 0);
        const auto size = [&](const ifs::Vector<2>& motion) {
            const auto points = view::dragged(drag, {drag.press + motion, 0}, {});
            return (points[1] - points[0]).norm() / (drag.vertices[1] - drag.vertices[0]).norm();
        };
        drag.mode = view::SpatialDrag::Mode::Scale;
        QVERIFY(size({20, 0}) > 1.2 && size({20, 0}) < 1.3);
        QVERIFY(size({-20, 0}) > 0.7 && size({-20, 0}) < 0.8);
        drag.mode = view::SpatialDrag::Mode::Rotate;
        const auto turned = view::dragged(drag, {drag.press + ifs::Vector<2>(0, -20), 0}, {});
        const double cosine = (turned[1] - turned[0]).dot(drag.vertices[1] - drag.vertices[0]) /
                              (drag.vertices[1] - drag.vertices[0]).squaredNorm();
        QVERIFY(cosine > 0.95 && cosine < 0.99); // 14 degrees
    }
}

void SpatialDragTest::theNearestAxisIsThatOfTheMotion() {
    const OrbitCamera camera = dragFrom(30, 20).camera;
    const ifs::Vector<3> at(0.2, 0.1, 0.3);
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            const ifs::Vector<2> motion =
                toScreen(camera, at + sign * 0.1 * ifs::Vector<3>::Unit(axis)).pixel -
                toScreen(camera, at).pixel;
            QCOMPARE(view::nearestAxis(camera, at, motion), std::optional(axis));
        }
    QVERIFY(!view::nearestAxis(camera, at, {0, 0}));
}

BARYCAGE_TEST(SpatialDragTest);
#include "spatial_drag_test.moc"
