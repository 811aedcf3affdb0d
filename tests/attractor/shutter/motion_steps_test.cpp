// SPDX-License-Identifier: MIT
#include "attractor/shutter/motion_steps.h"

#include "attractor/systems.h"
#include "support/named_test.h"

#include <QtTest>

using namespace attractor;

// How finely a shutter's time has to be divided.
class MotionStepsTest : public QObject {
    Q_OBJECT

private slots:
    // All of the picture moves by the same number of pixels.
    void aPanTakesAStepForEveryPixel() {
        const RenderRequest request = systems::request(systems::maple(), 1000);
        const auto panned = [&](double pixels) {
            RenderRequest moved = request;
            moved.camera.centre.x() += pixels / request.camera.pixelsPerUnit;
            return trackedPoints(moved);
        };
        QCOMPARE(stepsFor({panned(0), panned(0)}), 1);
        QCOMPARE(stepsFor({panned(0), panned(0.9)}), 1);
        QCOMPARE(stepsFor({panned(0), panned(5.5)}), 6);
        QCOMPARE(stepsFor({panned(0), panned(2.4), panned(3)}), 5); // the fastest part decides
        QCOMPARE(stepsFor({panned(0), panned(5000)}), maxSteps);
        QCOMPARE(stepsFor({panned(0)}), 1);
    }

    // The same address is the same point, however the weights change.
    void mapsMoveTheirPoints() {
        const RenderRequest request = systems::request(systems::sierpinski(), 1000);
        RenderRequest weighted = request;
        weighted.system.maps[0].weight = 0.7;
        QCOMPARE(stepsFor({trackedPoints(request), trackedPoints(weighted)}), 1);
        RenderRequest moved = request;
        moved.system.maps[1].map.translation.x() += 3 / request.camera.pixelsPerUnit;
        const int steps = stepsFor({trackedPoints(request), trackedPoints(moved)});
        QVERIFY2(steps == 6, qPrintable(QString::number(steps))); // its fixed point moves twice as far
    }

    void aMovedBranchIsTracked() {
        const RenderRequest request = systems::request(systems::sierpinski(), 1000);
        RenderRequest moved = request;
        moved.moved = {{{1}, ifs::affineMap(1, 0, 0, 1, 4.5 / request.camera.pixelsPerUnit, 0)}};
        QCOMPARE(stepsFor({trackedPoints(request), trackedPoints(moved)}), 5);
    }

    void whatIsNotInThePictureDoesNotCount() {
        RenderRequest request = systems::request(systems::sierpinski(), 1000);
        request.camera.centre = {0.1, 0.1};
        request.camera.pixelsPerUnit *= 4;
        RenderRequest moved = request;
        moved.moved = {{{1}, ifs::affineMap(1, 0, 0, 1, 0.2, 0)}}; // far to the right
        QCOMPARE(stepsFor({trackedPoints(request), trackedPoints(moved)}), 1);
    }

    void space() {
        SpaceRequest request;
        for (const ifs::Vector<3>& shift :
             {ifs::Vector<3>(0, 0, 0), ifs::Vector<3>(.5, 0, 0), ifs::Vector<3>(0, .5, 0)})
            ifs::append(request.system, ifs::AffineMap<3>{ifs::Matrix<3>::Identity() * 0.5, shift});
        request.camera.target = {.5, .5, 0};
        request.camera.height = 2;
        request.camera.size = {400, 400};
        SpaceRequest moved = request;
        moved.camera.target.x() += 2.5 * 2 / 400;
        QCOMPARE(stepsFor({trackedPoints(request), trackedPoints(moved)}), 3);
        QCOMPARE(stepsFor({trackedPoints(request), trackedPoints(request)}), 1);
    }

    void nothingToDrawMovesNothing() {
        RenderRequest empty = systems::request(systems::maple(), 1000);
        empty.system.maps.clear();
        QCOMPARE(stepsFor({trackedPoints(empty), trackedPoints(empty)}), 1);
        const RenderRequest full = systems::request(systems::maple(), 1000);
        QCOMPARE(stepsFor({trackedPoints(full), trackedPoints(empty)}), maxSteps); // nothing corresponds
    }
};

BARYCAGE_TEST(MotionStepsTest);
#include "motion_steps_test.moc"
