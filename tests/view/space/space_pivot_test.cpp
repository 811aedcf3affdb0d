// SPDX-License-Identifier: MIT
#include "document/edit_gesture.h"
#include "document/edits/timeline/motion_edits.h"
#include "document/edits/timeline/orbit_edits.h"
#include "support/named_test.h"
#include "view/space/space_window.h"

#include <QtTest>

#include <cmath>

using namespace space_window;

// What stays in its place while the view turns.
class SpacePivotTest : public QObject {
    Q_OBJECT

private slots:
    void besideTheSolidOneTurnsAboutIt();
    void anOrbitTurnsAboutItsPivot();
    void skewedSolidsTurnAboutTheirPivots();
    void anotherAxisIsSeenAtOnce();
};

// Not about the target, which may lie anywhere.
void SpacePivotTest::besideTheSolidOneTurnsAboutIt() {
    Window window;
    QVERIFY(window.rests());
    attractor::OrbitCamera beside = window.camera();
    beside.target = {1.5, 0.25, 3};
    beside.height = 4;
    window.view->navigation().moveTo(beside);
    QVERIFY(window.rests());
    const ifs::Vector<3> middle(0.5, 0.5, 0.5);
    const QPointF empty(20, 480);
    QVERIFY(!window.view->navigation().pointUnder(empty));
    const ifs::Vector<2> before = toScreen(window.camera(), middle).pixel;
    for (const Qt::MouseButton button : {Qt::LeftButton, Qt::RightButton}) {
        const attractor::OrbitCamera start = window.camera();
        window.drag(empty, {120, 440}, button);
        QVERIFY(window.camera().orientation.angularDistance(start.orientation) > 0.3);
        QVERIFY((toScreen(window.camera(), middle).pixel - before).norm() < 1e-3);
    }
}

void SpacePivotTest::anOrbitTurnsAboutItsPivot() {
    document::Fractal turning = *document::withOrbit(cubeOfEight());
    Window window(turning);
    QVERIFY(window.rests());
    attractor::OrbitCamera beside = window.camera();
    beside.target = {1.5, 0.25, 3};
    window.view->navigation().moveTo(beside);
    const ifs::Vector<3> middle(0.5, 0.5, 0.5);
    const ifs::Vector<2> before = toScreen(window.camera(), middle).pixel;
    for (const int frame : {30, 75, 110}) {
        window.document.setMoment(animation::moment(frame));
        QVERIFY((toScreen(window.camera(), middle).pixel - before).norm() < 1e-3);
    }
    window.document.setMoment(animation::moment(0));
    QVERIFY((window.camera().target - beside.target).norm() < 1e-12);
}

// Placed askew, about an axis that leans, about the middle of what is shown and about another point.
void SpacePivotTest::skewedSolidsTurnAboutTheirPivots() {
    document::Fractal skewed = cubeOfEight();
    document::space(skewed)->cage = document::spaceCage(skewed);
    auto& corners = document::space(skewed)->cage->current;
    corners[1] += ifs::Vector<3>(1, 0.5, 0);
    corners[2] += ifs::Vector<3>(0, 1, 2);
    const document::Fractal turning =
        *document::withOrbit(skewed, document::directionOf({.axis = 1, .lean = 30, .towards = 40}));
    document::OrbitPlace place = *document::orbitPlace(turning, 0);
    for (int i = 0; i < 3; ++i) {
        const auto [low, high] = document::extentAlong(skewed, ifs::Vector<3>::Unit(i));
        QVERIFY(std::abs(place.centre[i] - (low + high) / 2) < 1e-4);
    }
    for (const ifs::Vector<3>& pivot : {place.centre, ifs::Vector<3>(2, -1, 0.5)}) {
        place.centre = pivot;
        Window window(document::withOrbitPlace(turning, 0, place));
        QVERIFY(window.rests());
        const attractor::OrbitCamera start = window.camera();
        const ifs::Vector<2> before = toScreen(start, pivot).pixel;
        for (const int frame : {30, 75, 110}) {
            window.document.setMoment(animation::moment(frame));
            QVERIFY((toScreen(window.camera(), pivot).pixel - before).norm() < 1e-3);
            QVERIFY(window.camera().orientation.angularDistance(start.orientation) > 0.3);
        }
    }
}

// And when it is taken back, the view is what it was.
void SpacePivotTest::anotherAxisIsSeenAtOnce() {
    const document::Fractal turning = *document::withOrbit(cubeOfEight());
    Window window(turning);
    QVERIFY(window.rests());
    const attractor::OrbitCamera start = window.camera();
    window.document.setMoment(animation::moment(30));
    const attractor::OrbitCamera before = window.camera();
    document::OrbitPlace place = *document::orbitPlace(turning, 0);
    place.axis = ifs::Vector<3>::UnitX();
    document::EditGesture gesture = window.document.beginGesture(QStringLiteral("Change"));
    gesture.previewEntry(document::withOrbitPlace(turning, 0, place));
    const attractor::OrbitCamera wanted = animation::orbited(start, window.document.orbit());
    QVERIFY(window.camera().orientation.angularDistance(wanted.orientation) < 1e-7);
    QVERIFY(window.camera().orientation.angularDistance(before.orientation) > 0.5);
    gesture.cancel();
    QVERIFY(window.camera().orientation.angularDistance(before.orientation) < 1e-7);
    window.document.setMoment(animation::moment(0));
    QVERIFY(window.camera().orientation.angularDistance(start.orientation) < 1e-7);
    QVERIFY((window.camera().target - start.target).norm() < 1e-9);
}

BARYCAGE_TEST(SpacePivotTest, QApplication);
#include "space_pivot_test.moc"
