// SPDX-License-Identifier: MIT
#include "attractor/request/orbit_navigation.h"
#include "canvas/geometry/canvas_geometry.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "view/space/space_window.h"

#include <QNativeGestureEvent>
#include <QPointingDevice>

#include <cmath>

using namespace space_window;
using ifs::Vector;

namespace {

void gesture(const Window& window, Qt::NativeGestureType type, double value, const QPointF& at = {300, 250}) {
    QWidget* viewport = window.view->viewport();
    QNativeGestureEvent event(type, QPointingDevice::primaryPointingDevice(), 2, at, at,
                              viewport->mapToGlobal(at), value, QPointF());
    QCoreApplication::sendEvent(viewport, &event);
}

attractor::Direction directionOf(const Window& window) {
    return attractor::directionOf(window.camera());
}

// Where it lies in the plane of the target.
Vector<3> atTarget(const attractor::OrbitCamera& camera, const QPointF& pixel) {
    return toWorld(camera, {view::toVector(pixel), 0});
}

} // namespace

// Fingers on a touchpad and on a screen.
class SpaceTouchTest : public QObject {
    Q_OBJECT

private slots:
    void aPinchZoomsAtThePointer() {
        Window window;
        QVERIFY(window.rests());
        const attractor::OrbitCamera before = window.camera();
        const QPointF p(180, 140);
        const Vector<3> held = atTarget(before, p);
        gesture(window, Qt::BeginNativeGesture, 0, p);
        gesture(window, Qt::ZoomNativeGesture, 0.25, p);
        gesture(window, Qt::ZoomNativeGesture, 0.2, p);
        gesture(window, Qt::EndNativeGesture, 0, p);
        QVERIFY(std::abs(before.height / window.camera().height - 1.5) < 1e-9);
        QVERIFY((atTarget(window.camera(), p) - held).norm() < 1e-9);
        QVERIFY(window.camera().orientation.coeffs() == before.orientation.coeffs());
        QCOMPARE(window.document.undoStack()->count(), 0);
        gesture(window, Qt::SmartZoomNativeGesture, 0, p);
        QVERIFY(window.view->navigation().isFitted());
        QVERIFY(std::abs(window.camera().height / before.height - 1) < 1e-9);
    }

    // Small twists belong to the pinch that zooms; larger ones turn what is seen the way of the fingers.
    void twistingFingersTurnTheView() {
        Window window;
        QVERIFY(window.rests());
        const auto before = directionOf(window);
        const double height = window.camera().height;
        QVERIFY(before.elevation > 0);
        const auto turned = [&] { return std::remainder(directionOf(window).azimuth - before.azimuth, 360); };
        gesture(window, Qt::BeginNativeGesture, 0);
        gesture(window, Qt::RotateNativeGesture, 9);
        QCOMPARE(turned(), 0.0);
        gesture(window, Qt::RotateNativeGesture, 21); // clockwise
        QVERIFY(std::abs(turned() - 20) < 1e-6);
        QVERIFY(std::abs(directionOf(window).elevation - before.elevation) < 1e-6);
        QVERIFY(std::abs(window.camera().height / height - 1) < 1e-9);
        gesture(window, Qt::EndNativeGesture, 0);
        gesture(window, Qt::BeginNativeGesture, 0);
        gesture(window, Qt::RotateNativeGesture, -10);
        QVERIFY(std::abs(turned() - 20) < 1e-6);

        // From above, a corner of the cube goes clockwise about the middle of the screen.
        window.view->navigation().lookFrom(view::directions::top);
        QTRY_VERIFY(std::abs(directionOf(window).elevation - 90) < 1e-6);
        const auto angleOf = [&] {
            const Vector<2> pixel = toScreen(window.camera(), {1, 0.5, 0.5}).pixel -
                                    toScreen(window.camera(), {0.5, 0.5, 0.5}).pixel;
            return std::atan2(pixel.y(), pixel.x()) * 180 / M_PI; // clockwise: y points downwards
        };
        const double angle = angleOf();
        gesture(window, Qt::BeginNativeGesture, 0);
        gesture(window, Qt::RotateNativeGesture, 40);
        QVERIFY2(std::abs(std::remainder(angleOf() - angle - 30, 360)) < 2,
                 qPrintable(QString::number(angleOf() - angle)));
    }

    // One of Four Views always looks from its side.
    void aViewFromASideZoomsOnly() {
        Window window;
        window.view->fixDirection(view::directions::front, QStringLiteral("Front"));
        QVERIFY(window.rests());
        const attractor::OrbitCamera before = window.camera();
        gesture(window, Qt::BeginNativeGesture, 0);
        gesture(window, Qt::RotateNativeGesture, 60);
        QVERIFY(window.camera().orientation.coeffs() == before.orientation.coeffs());
        gesture(window, Qt::ZoomNativeGesture, 1);
        QVERIFY(std::abs(before.height / window.camera().height - 2) < 1e-9);
    }

    void fingersOnAScreen() {
        static const std::unique_ptr<QPointingDevice> screen(QTest::createTouchDevice());
        Window window;
        QVERIFY(window.rests());
        QWidget* viewport = window.view->viewport();
        const auto touch = [&] { return QTest::touchEvent(viewport, screen.get()); };
        // One drags a corner, in one step.
        const QPoint start = window.handle(1);
        const attractor::OrbitCamera before = window.camera();
        const Vector<3> vertex = window.vertices()[1];
        touch().press(1, start, viewport);
        touch().move(1, start + QPoint(10, -5), viewport);
        touch().move(1, start + QPoint(20, -10), viewport);
        touch().release(1, start + QPoint(20, -10), viewport);
        QCOMPARE(window.document.undoStack()->count(), 1);
        const Vector<2> way = toScreen(before, window.vertices()[1]).pixel - toScreen(before, vertex).pixel;
        QVERIFY((way - Vector<2>(20, -10)).norm() < 1e-6);
        // Beside the handles it turns the view.
        touch().press(1, QPoint(20, 480), viewport);
        touch().move(1, QPoint(60, 480), viewport);
        touch().release(1, QPoint(60, 480), viewport);
        QVERIFY(window.camera().orientation.coeffs() != before.orientation.coeffs());
        // Two hold what is under them, and take nothing along.
        const attractor::OrbitCamera camera = window.camera();
        const auto vertices = window.vertices();
        const Vector<3> left = atTarget(camera, {200, 200}), right = atTarget(camera, {300, 200});
        touch().press(1, QPoint(200, 200), viewport);
        touch().move(1, QPoint(200, 200), viewport).press(2, QPoint(300, 200), viewport);
        touch().move(1, QPoint(150, 220), viewport).move(2, QPoint(350, 220), viewport);
        touch().release(1, QPoint(150, 220), viewport).release(2, QPoint(350, 220), viewport);
        QVERIFY(std::abs(camera.height / window.camera().height - 2) < 1e-9);
        QVERIFY((atTarget(window.camera(), {150, 220}) - left).norm() < 1e-9);
        QVERIFY((atTarget(window.camera(), {350, 220}) - right).norm() < 1e-9);
        QVERIFY(window.vertices() == vertices);
        QCOMPARE(window.document.undoStack()->count(), 1);
    }
};

BARYCAGE_TEST(SpaceTouchTest, QApplication);
#include "space_touch_test.moc"
