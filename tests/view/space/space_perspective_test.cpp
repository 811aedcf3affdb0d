// SPDX-License-Identifier: MIT
#include "space/four_views.h"
#include "support/named_test.h"
#include "view/space/space_window.h"

using namespace space_window;
using view::SpaceNavigation;

// When a window into space shows perspective.
class SpacePerspectiveTest : public QObject {
    Q_OBJECT

private slots:
    void anAxisViewIsOrthographicUntilOneOrbits_data();
    void anAxisViewIsOrthographicUntilOneOrbits();
    void whatIsChosenOutlastsAnAxisView();
    void fourViewsLendPerspective_data();
    void fourViewsLendPerspective();
    void whatIsChosenInFourViewsStays_data();
    void whatIsChosenInFourViewsStays();
    void keysOfTheCameraDecideInFourViews();
};

namespace {

// A menu that shows the projection sets what it shows.
void echo(SpaceNavigation& navigation) {
    QObject::connect(&navigation, &SpaceNavigation::perspectiveChanged, &navigation,
                     &SpaceNavigation::setPerspective);
}

struct Views {
    document::Document document;
    std::unique_ptr<view::SolidBridge> bridge;
    std::unique_ptr<view::FourViews> views;

    Views() {
        document.edit(QStringLiteral("Begin"), cubeOfEight());
        document.undoStack()->clear();
        bridge = std::make_unique<view::SolidBridge>(&document);
        views = std::make_unique<view::FourViews>(&document, bridge.get());
        views->resize(800, 600);
        views->show();
        echo(navigation());
    }
    SpaceNavigation& navigation() const { return views->main()->navigation(); }
};

} // namespace

void SpacePerspectiveTest::anAxisViewIsOrthographicUntilOneOrbits_data() {
    QTest::addColumn<bool>("byKey");
    QTest::newRow("mouse") << false;
    QTest::newRow("arrow key") << true;
}

void SpacePerspectiveTest::anAxisViewIsOrthographicUntilOneOrbits() {
    QFETCH(const bool, byKey);
    Window window;
    QVERIFY(window.rests());
    SpaceNavigation& navigation = window.view->navigation();
    echo(navigation);
    navigation.setPerspective(true);
    navigation.lookFrom(view::directions::top);
    QTRY_VERIFY(view::AxisBall::looksFrom(window.camera(), {1, true}));
    QVERIFY(!navigation.isPerspective());
    if (byKey)
        QTest::keyClick(window.view.get(), Qt::Key_Down);
    else
        window.drag({20, 480}, {80, 400});
    QVERIFY(navigation.isPerspective());
}

void SpacePerspectiveTest::whatIsChosenOutlastsAnAxisView() {
    Window window;
    QVERIFY(window.rests());
    SpaceNavigation& navigation = window.view->navigation();
    echo(navigation);
    QVERIFY(!navigation.isPerspectiveChosen());
    navigation.setPerspective(true);
    navigation.lookFrom(view::directions::front);
    QVERIFY(navigation.isPerspectiveChosen() && !navigation.isPerspective());
    navigation.setPerspective(true); // in that view, too
    QVERIFY(navigation.isPerspective());
    navigation.setPerspective(false);
    QVERIFY(!navigation.isPerspectiveChosen());
    window.drag({20, 480}, {80, 400});
    QVERIFY(!navigation.isPerspective());
}

void SpacePerspectiveTest::fourViewsLendPerspective_data() {
    QTest::addColumn<bool>("chosen");
    QTest::addColumn<bool>("alongAxis");
    QTest::newRow("orthographic") << false << false;
    QTest::newRow("orthographic, along an axis") << false << true;
    QTest::newRow("perspective") << true << false;
    QTest::newRow("perspective, along an axis") << true << true;
}

void SpacePerspectiveTest::fourViewsLendPerspective() {
    QFETCH(const bool, chosen);
    QFETCH(const bool, alongAxis);
    Views window;
    SpaceNavigation& navigation = window.navigation();
    navigation.setPerspective(chosen);
    if (alongAxis) navigation.lookFrom(view::directions::front);
    const bool before = navigation.isPerspective();
    window.views->showFour(true);
    QVERIFY(navigation.isPerspective());
    for (view::SpaceView* other : window.views->others())
        QVERIFY(!other->navigation().isPerspective());
    QCOMPARE(navigation.isPerspectiveChosen(), chosen);
    QVERIFY(!window.document.isModified());
    window.views->showFour(false);
    QCOMPARE(navigation.isPerspective(), before);
    navigation.leaveAxisView();
    QCOMPARE(navigation.isPerspective(), chosen);
}

void SpacePerspectiveTest::whatIsChosenInFourViewsStays_data() {
    QTest::addColumn<bool>("chosen");
    QTest::newRow("orthographic") << false;
    QTest::newRow("perspective") << true;
}

void SpacePerspectiveTest::whatIsChosenInFourViewsStays() {
    QFETCH(const bool, chosen);
    Views window;
    SpaceNavigation& navigation = window.navigation();
    window.views->showFour(true);
    navigation.setPerspective(false);
    QVERIFY(!navigation.isPerspective());
    navigation.setPerspective(chosen);
    window.views->showFour(false);
    QCOMPARE(navigation.isPerspective(), chosen);
    QCOMPARE(navigation.isPerspectiveChosen(), chosen);
}

void SpacePerspectiveTest::keysOfTheCameraDecideInFourViews() {
    Views window;
    SpaceNavigation& navigation = window.navigation();
    window.views->showFour(true);
    attractor::OrbitCamera keyed = navigation.camera();
    keyed.projection = attractor::OrbitCamera::Projection::Orthographic;
    navigation.followKeys(keyed, false);
    QVERIFY(!navigation.isPerspective());
    navigation.leaveAxisView(); // begins an orbit
    QVERIFY(!navigation.isPerspective());
}

BARYCAGE_TEST(SpacePerspectiveTest, QApplication);
#include "space_perspective_test.moc"
