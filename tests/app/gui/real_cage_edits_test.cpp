// SPDX-License-Identifier: MIT
#include "canvas/scene/canvas_scene.h"
#include "canvas/tools/vertex_dialog.h"
#include "document/fractal/fractal_geometry.h"
#include "support/window_on_x.h"

#include <QLineEdit>
#include <QMenu>

#include <cmath>

using ifs::Vector;
using view::CanvasPart;
using Kind = view::CanvasPart::Kind;

// The cage by other means than dragging it: fitted, typed, baked, with more corners; with a real pointer and
// real keys.
class RealCageEditsTest : public support::WindowOnX {
    Q_OBJECT

private slots:
    void init() { openWindow(); }
    void cleanup() { closeWindow(); }

    void theMinimalSimplexIsFitted();
    void aPlacementIsBakedAndUnbaked();
    void rewritingChangesTheCode();
    void aVertexIsTypedFromItsMenu();
    void cornersAreSelectedTogether_data();
    void cornersAreSelectedTogether();
    void cornersComeAndGo();
};

void RealCageEditsTest::theMinimalSimplexIsFitted() {
    const std::vector<Vector<2>> canonical = vertices(); // what the maple opens with
    const QPoint middle = middleOf(canvas().viewport());
    hand().key("d");
    for (const QPoint corner : {QPoint(-150, 120), QPoint(160, 130), QPoint(10, -180)})
        hand().clickAt(middle + corner);
    QTRY_COMPARE(steps(), 1);
    QVERIFY(vertices() != canonical);
    choose({QStringLiteral("Cage"), QStringLiteral("More"), QStringLiteral("Fit Minimal Canonical Simplex")});
    QTRY_COMPARE(steps(), 2);
    for (std::size_t i = 0; i < 3; ++i)
        QVERIFY((vertices()[i] - canonical[i]).norm() * pixelsPerUnit() < 1);
    QVERIFY(cage().rest == cage().current); // the picture stays where it is
}

void RealCageEditsTest::aPlacementIsBakedAndUnbaked() {
    const document::Fractal before = fractal();
    dragBy(vertex(1), {-70, 40});
    QTRY_COMPARE(steps(), 1);
    const std::vector<Vector<2>> placed = vertices();
    const document::System2 shown = *document::effectiveSystem(fractal());
    hand().key("Control+b");
    QTRY_COMPARE(steps(), 2);
    QVERIFY(code() == shown); // the code draws now what was shown
    QCOMPARE(vertices(), placed);
    QVERIFY(cage().rest == cage().current);

    choose({QStringLiteral("Cage"), QStringLiteral("More"), QStringLiteral("Unbake")});
    QTRY_COMPARE(steps(), 3);
    QCOMPARE(vertices(), placed);
    QCOMPARE(cage().rest, (std::vector<Vector<2>>{{0, 0}, {1, 0}, {0, 1}}));
    for (int i = 0; i < 3; ++i)
        hand().key("Control+z");
    QTRY_VERIFY(fractal() == before);
}

void RealCageEditsTest::rewritingChangesTheCode() {
    const document::System2 before = code();
    const std::vector<Vector<2>> held = vertices();
    choose({QStringLiteral("Cage"), QStringLiteral("More"), QStringLiteral("Rewrite")});
    dragBy(insideTheCage(), {-40, -30});
    QTRY_COMPARE(steps(), 1);
    const Vector<2> shift = vertices()[0] - held[0];
    QVERIFY(offsetInPixels(vertices()[0], held[0], {-40, -30}) < 1e-6);
    QVERIFY(cage().rest == cage().current);
    for (std::size_t i = 0; i < before.maps.size(); ++i) { // the conjugate by a shift
        const auto& old = before.maps[i].map;
        const auto& now = code().maps[i].map;
        QVERIFY((now.linear - old.linear).norm() < 1e-12);
        QVERIFY((now.translation - (old.translation + shift - old.linear * shift)).norm() < 1e-12);
    }
}

void RealCageEditsTest::aVertexIsTypedFromItsMenu() {
    hand().clickAt(vertex(2), support::XInput::Right);
    QTRY_VERIFY(visible<QMenu>());
    chooseFrom(visible<QMenu>(), QStringLiteral("Coordinates…"));
    QTRY_VERIFY(visible<view::VertexDialog>());
    QVERIFY(QTest::qWaitForWindowActive(visible<view::VertexDialog>()));
    QVERIFY(support::waitFor([] { return support::isInPlace(visible<view::VertexDialog>()); }));
    type(named<QLineEdit>(*visible<view::VertexDialog>(), QStringLiteral("x of the vertex")),
         QStringLiteral("0.5"));
    type(named<QLineEdit>(*visible<view::VertexDialog>(), QStringLiteral("y of the vertex")),
         QStringLiteral("7,25")); // a comma may stand for the point
    hand().key("Return");
    QTRY_VERIFY(!visible<view::VertexDialog>());
    QCOMPARE(vertices()[2], Vector<2>(0.5, 7.25));
    QCOMPARE(steps(), 1);
}

void RealCageEditsTest::cornersAreSelectedTogether_data() {
    QTest::addColumn<bool>("byRectangle");
    QTest::newRow("clicked with Shift") << false;
    QTest::newRow("by a rectangle") << true;
}

void RealCageEditsTest::cornersAreSelectedTogether() {
    QFETCH(bool, byRectangle);
    zoomOut(3); // room around the cage
    if (byRectangle) {
        const QRect around = QRect(vertex(0), QSize(1, 1)) | QRect(vertex(1), QSize(1, 1));
        hand().drag(around.topLeft() - QPoint(25, 25),
                    {around.center(), around.bottomRight() + QPoint(25, 25)});
    } else {
        hand().clickAt(vertex(0));
        hand().hold("Shift");
        hand().clickAt(vertex(1));
        hand().letUp("Shift");
    }
    QTRY_COMPARE(canvas().canvas().selection().vertices(), (std::vector<std::size_t>{0, 1}));
    const std::vector<Vector<2>> held = vertices();
    dragBy(vertex(1), {-30, -45});
    QTRY_COMPARE(steps(), 1);
    QVERIFY(offsetInPixels(vertices()[0], held[0], {-30, -45}) < 1e-6);
    QVERIFY(offsetInPixels(vertices()[1], held[1], {-30, -45}) < 1e-6);
    QCOMPARE(vertices()[2], held[2]);
}

void RealCageEditsTest::cornersComeAndGo() {
    const std::vector<Vector<2>> held = vertices();
    const QPoint third = (vertex(0) * 2 + vertex(1)) / 3;
    hand().moveTo(third);
    hand().key("Insert"); // on the edge under the pointer
    QTRY_COMPARE(vertices().size(), std::size_t{4});
    QVERIFY((onScreen(vertices()[1]) - third).manhattanLength() <= 3);
    QCOMPARE(vertices()[2], held[1]);
    hand().doubleClickAt((vertex(2) + vertex(3)) / 2);
    QTRY_COMPARE(vertices().size(), std::size_t{5});
    dragBy(vertex(3), {18, -12});
    QTRY_COMPARE(steps(), 3);
    hand().clickAt(vertex(1));
    hand().key("Delete");
    QTRY_COMPARE(vertices().size(), std::size_t{4});
    QCOMPARE(vertices()[1], held[1]);

    const bool answered = answer<QDialog>([&] { hand().key("Control+Shift+s"); }, // and it is kept
                                          [&](QDialog&) {
                                              hand().key("Control+a");
                                              hand().type(folder() + QStringLiteral("/bent.ifs"));
                                              hand().key("Return");
                                          });
    QVERIFY(answered);
    QTRY_VERIFY(!window().isWindowModified());
    QCOMPARE(document::plane(savedEntry(folder() + QStringLiteral("/bent.ifs")))->cage,
             document::plane(fractal())->cage);
}

BARYCAGE_TEST_ON_X(RealCageEditsTest);

#include "real_cage_edits_test.moc"
