// SPDX-License-Identifier: MIT
#include "attractor/request/orbit_navigation.h"
#include "canvas/geometry/canvas_geometry.h"
#include "support/named_test.h"
#include "view/space/space_window.h"

#include <QFocusEvent>
#include <QKeyEvent>
#include <QWheelEvent>

#include <cmath>

using namespace space_window;
using ifs::Vector;

namespace {

void key(const Window& window, QEvent::Type type, Qt::Key key, Qt::KeyboardModifiers modifiers = {},
         bool repeats = false, quint64 stamp = 0) {
    QKeyEvent event(type, key, modifiers, {}, repeats);
    event.setTimestamp(stamp);
    QCoreApplication::sendEvent(window.view.get(), &event);
}

void turnWheel(const Window& window, const QPoint& pixels, const QPoint& angle,
               Qt::KeyboardModifiers modifiers = {}) {
    QWidget* viewport = window.view->viewport();
    const QPointF at(150, 120);
    QWheelEvent event(at, viewport->mapToGlobal(at), pixels, angle, Qt::NoButton, modifiers,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(viewport, &event);
}

} // namespace

// What keys, wheel and focus do to a drag, in space as on the canvas of the plane.
class SpaceGesturesTest : public QObject {
    Q_OBJECT

private slots:
    void aHeldArrowIsOneStep() {
        Window window;
        QVERIFY(window.rests());
        const auto before = window.vertices();
        const auto camera = window.camera();
        QTest::keyClick(window.view.get(), Qt::Key_Tab);
        key(window, QEvent::KeyPress, Qt::Key_Right);
        for (int i = 0; i < 9; ++i) {
            key(window, QEvent::KeyRelease, Qt::Key_Right, {}, true);
            key(window, QEvent::KeyPress, Qt::Key_Right, {}, true);
        }
        key(window, QEvent::KeyRelease, Qt::Key_Right);
        QCOMPARE(window.document.undoStack()->count(), 1);
        const Vector<2> way =
            toScreen(camera, window.vertices()[0]).pixel - toScreen(camera, before[0]).pixel;
        QVERIFY((way - Vector<2>(10, 0)).norm() < 1e-6);
        window.document.undoStack()->undo();
        QVERIFY(window.vertices() == before);
    }

    // As an X server reports it: the key goes up and down at the same time.
    void aKeyThatRepeatsOnXIsOneStep() {
        Window window;
        QVERIFY(window.rests());
        QTest::keyClick(window.view.get(), Qt::Key_Tab);
        quint64 stamp = 1000;
        key(window, QEvent::KeyPress, Qt::Key_Up, {}, false, stamp);
        for (int i = 0; i < 5; ++i) {
            stamp += 30;
            key(window, QEvent::KeyRelease, Qt::Key_Up, {}, false, stamp);
            key(window, QEvent::KeyPress, Qt::Key_Up, {}, false, stamp);
        }
        key(window, QEvent::KeyRelease, Qt::Key_Up, {}, false, stamp + 30);
        QTRY_COMPARE(window.document.undoStack()->count(), 1);
    }

    void escapeTakesAHeldArrowBack() {
        Window window;
        QVERIFY(window.rests());
        const auto before = window.vertices();
        QTest::keyClick(window.view.get(), Qt::Key_Tab);
        key(window, QEvent::KeyPress, Qt::Key_Down);
        QVERIFY(window.vertices() != before);
        QTest::keyClick(window.view.get(), Qt::Key_Escape);
        QVERIFY(window.vertices() == before);
        key(window, QEvent::KeyRelease, Qt::Key_Down);
        QCOMPARE(window.document.undoStack()->count(), 0);
    }

    void withoutTheFocusTheSpaceBarIsUp() {
        Window window;
        QVERIFY(window.rests());
        key(window, QEvent::KeyPress, Qt::Key_Space);
        QCOMPARE(window.view->viewport()->cursor().shape(), Qt::OpenHandCursor);
        QFocusEvent lost(QEvent::FocusOut, Qt::ActiveWindowFocusReason);
        QCoreApplication::sendEvent(window.view.get(), &lost);
        QCOMPARE(window.view->viewport()->cursor().shape(), Qt::CrossCursor);
        const attractor::OrbitCamera before = window.camera();
        window.drag({20, 480}, {80, 480});
        QVERIFY(window.camera().orientation.coeffs() != before.orientation.coeffs()); // it turns
    }

    void keysPressedDuringTheDragCount() {
        Window window;
        QVERIFY(window.rests());
        const auto before = window.vertices();
        const QPointF start = window.handle(1);
        const auto lengths = [&window] {
            const auto v = window.vertices();
            return Vector<3>((v[1] - v[0]).norm(), (v[2] - v[0]).norm(), (v[3] - v[1]).norm());
        };
        const Vector<3> atRest = lengths();
        window.send(QEvent::MouseButtonPress, start, Qt::LeftButton);
        window.send(QEvent::MouseMove, start + QPointF(40, 10), Qt::LeftButton);
        QVERIFY(window.vertices()[0] == before[0]);
        key(window, QEvent::KeyPress, Qt::Key_Control); // without a motion of the pointer
        QVERIFY(window.vertices()[0] != before[0]);
        QVERIFY((lengths() - atRest).norm() < 1e-9);
        key(window, QEvent::KeyRelease, Qt::Key_Control, Qt::ControlModifier); // still a rotation
        window.send(QEvent::MouseMove, start + QPointF(40, 20), Qt::LeftButton);
        QVERIFY(window.vertices()[0] != before[0]);
        QVERIFY((lengths() - atRest).norm() < 1e-9);
        window.send(QEvent::MouseMove, start + QPointF(40, 20), Qt::LeftButton, Qt::AltModifier);
        QVERIFY((lengths() - atRest).norm() > 1e-3);
        const Vector<3> ratios = lengths().cwiseQuotient(atRest);
        QVERIFY(ratios.maxCoeff() - ratios.minCoeff() < 1e-9); // it scales
        window.send(QEvent::MouseButtonRelease, start + QPointF(40, 20), Qt::LeftButton, Qt::AltModifier);
        QCOMPARE(window.document.undoStack()->undoText(), QStringLiteral("Scale Cage"));
        QCOMPARE(window.document.undoStack()->count(), 1);
        window.document.undoStack()->undo();
        QVERIFY(window.vertices() == before);
    }

    void aTrackpadScrollsByPixels() {
        Window window;
        QVERIFY(window.rests());
        const double height = window.camera().height;
        turnWheel(window, {0, 60}, {}); // as much as a notch
        const double after = window.camera().height;
        QVERIFY(after < height);
        turnWheel(window, {0, -60}, {});
        QVERIFY(std::abs(window.camera().height / height - 1) < 1e-9);
        turnWheel(window, {}, {0, 120});
        QVERIFY(std::abs(window.camera().height / after - 1) < 1e-9);
    }

    // As the wheel does with Alt held on some platforms.
    void aWheelTurnedSidewaysZooms() {
        Window window;
        QVERIFY(window.rests());
        const double height = window.camera().height;
        turnWheel(window, {}, {120, 0}, Qt::AltModifier);
        QVERIFY(window.camera().height < height);
        turnWheel(window, {}, {0, -120});
        QVERIFY(std::abs(window.camera().height / height - 1) < 1e-9);
    }

    void aClickThatShakesMovesNothing() {
        Window window;
        QVERIFY(window.rests());
        const QPointF start = window.handle(2);
        const auto before = window.vertices();
        window.send(QEvent::MouseButtonPress, start, Qt::LeftButton);
        window.send(QEvent::MouseMove, start + QPointF(1, 1), Qt::LeftButton);
        window.send(QEvent::MouseButtonRelease, start + QPointF(1, 1), Qt::LeftButton);
        QVERIFY(window.vertices() == before);
        QCOMPARE(window.document.undoStack()->count(), 0);
    }
};

BARYCAGE_TEST(SpaceGesturesTest, QApplication);
#include "space_gestures_test.moc"
