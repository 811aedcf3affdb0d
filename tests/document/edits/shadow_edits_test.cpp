// SPDX-License-Identifier: MIT
#include "document/edits/shadow_edits.h"

#include "document/edits/dimension_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "ifs/cage/control_cage.h"
#include "support/named_test.h"

#include <QtTest>

using namespace document;
using attractor::YAxis;
using ifs::Vector;

class ShadowEditsTest : public QObject {
    Q_OBJECT

private:
    static Fractal shadowed() { return withShadow(sierpinskiTriangle(), true); }
    static attractor::Camera camera(YAxis yAxis) {
        attractor::Camera camera;
        camera.width = camera.height = 100;
        camera.yAxis = yAxis;
        return camera;
    }

private slots:
    void aShadowIsSwitchedOnAndOff() {
        const Fractal plain = sierpinskiTriangle();
        QVERIFY(!hasShadow(plain) && !shadowMap(plain, YAxis::Up) && !shadowStick(plain, YAxis::Up));
        QVERIFY(!renderRequest(plain, camera(YAxis::Up)).shadow);
        Fractal fractal = shadowed();
        QVERIFY(hasShadow(fractal) && shadowMap(fractal, YAxis::Up));
        QVERIFY(withShadow(fractal, false) == plain);
        fractal.appearance.shadow = 0.2;
        QVERIFY(withShadow(fractal, true) == fractal); // as strong as it was
    }

    void aSolidSaysWhyItHasNone() {
        const auto solid = lifted(sierpinskiTriangle());
        QVERIFY(solid);
        QVERIFY(shadowObstacle(*solid).contains(QLatin1String("light")));
        QVERIFY(!hasShadow(withShadow(*solid, true)));
        QVERIFY(shadowObstacle(sierpinskiTriangle()).isEmpty());
    }

    // The ground is the lowest line of the picture as it is seen, also where the cage has put it.
    void theGroundIsUnderThePicture() {
        for (const YAxis yAxis : {YAxis::Up, YAxis::Down}) {
            Fractal fractal = shadowed();
            fractal.appearance.shadowLean = 0.5;
            fractal.appearance.shadowLength = 0.25;
            ifs::ControlCage<2> cage = effectiveCage(fractal);
            for (auto& vertex : cage.current)
                vertex = 2 * vertex + Vector<2>(1, 7);
            plane(fractal)->cage = cage;
            const auto box = displayedBox(fractal);
            const auto map = shadowMap(fractal, yAxis);
            QVERIFY(box && map);
            const double ground = yAxis == YAxis::Up ? box->min.y() : box->max.y();
            const double up = yAxis == YAxis::Up ? 1 : -1;
            QVERIFY(((*map)(Vector<2>(3, ground)) - Vector<2>(3, ground)).norm() < 1e-9);
            const Vector<2> high(3, ground + up);
            QVERIFY(((*map)(high)-Vector<2>(3.5, ground + up * 0.25)).norm() < 1e-9);
            QVERIFY(renderRequest(fractal, camera(yAxis)).shadow == map);
        }
    }

    void theBoxHoldsTheShadow_data() {
        QTest::addColumn<bool>("bends");
        QTest::newRow("affine") << false;
        QTest::newRow("bent") << true;
    }
    void theBoxHoldsTheShadow() {
        QFETCH(const bool, bends);
        Fractal fractal = shadowed();
        fractal.appearance.shadowLean = 1.5;
        fractal.appearance.shadowLength = -0.5; // to the front
        if (bends)
            plane(fractal)->cage = ifs::ControlCage<2>{{{-1, -1}, {2, -1}, {2, 2}, {-1, 2}},
                                                       {{-1, -1}, {2, -1}, {1.5, 2}, {-0.5, 2.5}}};
        const auto box = displayedBox(fractal), both = boxWithShadow(fractal, YAxis::Up);
        const auto map = shadowMap(fractal, YAxis::Up);
        QVERIFY(box && both && map);
        QVERIFY(both->min.y() < box->min.y() - 0.3 && both->max.x() > box->max.x() + 0.1);
        const ifs::Placement placed = placement(fractal);
        for (const auto& row : system2(fractal)->maps) {
            Vector<2> corner = Vector<2>::Zero(); // of the triangle: the fixed point
            for (int k = 0; k < 60; ++k)
                corner = row.map(corner);
            const Vector<2> fallen = (*map)(placed(corner));
            QVERIFY((fallen - both->min).minCoeff() > -0.02 && (both->max - fallen).minCoeff() > -0.02);
        }
        fractal.appearance.shadow = 0;
        QVERIFY(boxWithShadow(fractal, YAxis::Up)->max == box->max);
    }

    void theTipGoesWhereItIsPut() {
        for (const YAxis yAxis : {YAxis::Up, YAxis::Down}) {
            const Fractal fractal = shadowed();
            const auto stick = shadowStick(fractal, yAxis);
            QVERIFY(stick);
            QVERIFY(((*shadowMap(fractal, yAxis))(stick->top) - stick->tip).norm() < 1e-9);
            const Vector<2> wanted = stick->foot + Vector<2>(-0.75, 0.125);
            const Fractal turned = withShadowTip(fractal, *stick, wanted);
            QVERIFY((shadowStick(turned, yAxis)->tip - wanted).norm() < 1e-9);
            QVERIFY(((*shadowMap(turned, yAxis))(stick->top) - wanted).norm() < 1e-9);
            const Fractal far = withShadowTip(fractal, *stick, stick->foot + Vector<2>(1e6, 0));
            QCOMPARE(far.appearance.shadowLean, 10.0);
        }
    }
};

BARYCAGE_TEST(ShadowEditsTest);
#include "shadow_edits_test.moc"
