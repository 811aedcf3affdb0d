// SPDX-License-Identifier: MIT
#include "view/space/space_window.h"

using namespace space_window;
using view::SpaceNavigation;

// When the window into space shows perspective.
class SpacePerspectiveTest : public QObject {
    Q_OBJECT

private slots:
    void anAxisViewIsOrthographicUntilOneOrbits_data();
    void anAxisViewIsOrthographicUntilOneOrbits();
    void whatIsChosenOutlastsAnAxisView();
};

namespace {

// A menu that shows the projection sets what it shows.
void echo(SpaceNavigation& navigation) {
    QObject::connect(&navigation, &SpaceNavigation::perspectiveChanged, &navigation,
                     &SpaceNavigation::setPerspective);
}

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

QTEST_MAIN(SpacePerspectiveTest)
#include "space_perspective_test.moc"
