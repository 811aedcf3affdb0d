// SPDX-License-Identifier: MIT
#include "bars/branch_bar.h"
#include "canvas/scene/canvas_scene.h"
#include "document/fractal/fractal_geometry.h"
#include "ifs/system/branch.h"
#include "io/file/save_file.h"
#include "support/window_on_x.h"

#include <QComboBox>
#include <QPushButton>
#include <QSpinBox>
#include <QStatusBar>

using ifs::Vector;
using ifs::Word;
using view::CanvasPart;
using Kind = view::CanvasPart::Kind;

// Branches taken on the canvas, with a real pointer and real keys. The pieces of the system do not touch, so
// that every point has one address.
class RealBranchTest : public support::WindowOnX {
    Q_OBJECT

private slots:
    void init() {
        openWindow();
        if (QTest::currentTestFailed()) return;
        m_path = folder() + QStringLiteral("/apart.ifs");
        QVERIFY(
            !io::saveFile(m_path, "apart {\n .4 0 0 .4 0 0 .3\n .4 0 0 .4 .6 0 .3\n .4 0 0 .4 0 .6 .4\n}\n"));
        QVERIFY(window().openPath(m_path));
        hand().key("b");
        QTRY_COMPARE(canvas().tool(), view::CanvasView::Tool::Branch);
    }
    void cleanup() { closeWindow(); }

    void theDepthOfABranchIsChosen();
    void aBranchBecomesAMapOfItsOwn();
    void theStatusBarForgetsTheHandleBefore();
    void theLastMapOfItsAddressChanges();
    void aBranchIsShownElsewhereAndPutBack();

private:
    const view::BranchBar& bar() const { return *window().findChild<view::BranchBar*>(); }
    const Word& branch() const { return canvas().canvas().handles().branch(); }
    QPoint pointOf(const Word& word) const {
        const Vector<2> point = *ifs::addressPoint<2>(ifs::activeMaps(code()).maps, word, {0, 1, 2});
        return onScreen(document::placement(fractal())(point));
    }
    void select(const Word& word) {
        hand().clickAt(pointOf(word));
        QTRY_COMPARE(branch(), Word(word.begin(), word.begin() + 2));
    }

    QString m_path;
};

void RealBranchTest::theDepthOfABranchIsChosen() {
    select({1, 2, 0});
    hand().hold("Shift");
    hand().wheel(-1);
    hand().letUp("Shift");
    QTRY_COMPARE(canvas().tools().branchTool().choice().depth(), 1);
    QCOMPARE(branch(), Word{1});
    type(bar().depth(), QStringLiteral("3"));
    QTRY_COMPARE(branch(), (Word{1, 2, 0}));
    QCOMPARE(steps(), 0);
}

void RealBranchTest::aBranchBecomesAMapOfItsOwn() {
    const document::System2 before = code();
    select({1, 2, 0});
    const QPoint corner = handle({Kind::Vertex, 0, 0});
    dragBy(corner, {9, -12});
    QTRY_COMPARE(steps(), 1);
    QVERIFY(document().undoStack()->undoText().startsWith(QStringLiteral("Move corner 1 of branch 2 3 ")));
    QCOMPARE(code().maps.size(), std::size_t{5}); // the branch and those beside it
    QVERIFY(code().maps[1].map == before.maps[1].map * before.maps[0].map);
    QVERIFY((handle({Kind::Vertex, 0, 0}) - corner - QPoint(9, -12)).manhattanLength() <= 2);
    photograph(QStringLiteral("branch.png"));
    hand().key("Control+z");
    QTRY_VERIFY(code() == before);
    QTRY_COMPARE(branch(), (Word{1, 2})); // still selected, ready for the next try
    QCOMPARE(window().statusBar()->currentMessage(), QStringLiteral("Branch 2 3"));
    QVERIFY((handle({Kind::Vertex, 0, 0}) - corner).manhattanLength() <= 2);
    hand().key("Control+Shift+z");
    QTRY_COMPARE(branch(), Word{0});
    hand().key("Control+z");
    dragBy(handle({Kind::Vertex, 0, 0}), {-8, 5});
    QTRY_COMPARE(code().maps.size(), std::size_t{5});
}

// The status bar speaks of the handle that is held or has the focus, or of none.
void RealBranchTest::theStatusBarForgetsTheHandleBefore() {
    hand().key("c");
    QTRY_COMPARE(canvas().tool(), view::CanvasView::Tool::Cage);
    hand().key("Tab");
    QTRY_VERIFY(window().statusBar()->currentMessage().startsWith(QStringLiteral("Vertex 1")));
    hand().moveTo(vertex(1));
    hand().press();
    QTRY_COMPARE(canvas().canvas().selection().focused(), (CanvasPart{Kind::Vertex, 1}));
    QVERIFY2(!window().statusBar()->currentMessage().contains(QStringLiteral("Vertex 1")),
             qPrintable(window().statusBar()->currentMessage()));
    hand().release();
    hand().key("Control+z"); // nothing was dragged
    hand().key("Right");
    QTRY_VERIFY(window().statusBar()->currentMessage().startsWith(QStringLiteral("Vertex 2")));
    QTRY_COMPARE(steps(), 1);
    const QString moved = window().statusBar()->currentMessage();
    hand().key("Control+z");
    QTRY_COMPARE(document().undoStack()->index(), 0);
    QTRY_VERIFY_WITH_TIMEOUT(window().statusBar()->currentMessage() != moved, 500);
    QVERIFY(window().statusBar()->currentMessage().startsWith(QStringLiteral("Vertex 2")));
    // A branch that was moved by a key is called by its address again.
    hand().key("b");
    QTRY_COMPARE(canvas().tool(), view::CanvasView::Tool::Branch);
    select({1, 2, 0});
    hand().key("Tab");
    QTRY_VERIFY(canvas().canvas().selection().focused() != CanvasPart());
    hand().key("Right");
    QTRY_COMPARE(code().maps.size(), std::size_t{5});
    QTRY_COMPARE(branch(), Word{0});
    QTRY_COMPARE(document().undoStack()->index(), 1);
    hand().key("Control+z");
    QTRY_COMPARE(code().maps.size(), std::size_t{3});
    QTRY_VERIFY_WITH_TIMEOUT(window().statusBar()->currentMessage().startsWith(QStringLiteral("Branch 2 3")),
                             500);
}

void RealBranchTest::theLastMapOfItsAddressChanges() {
    const document::System2 before = code();
    pick(bar().edit(), document::BranchEdit::LastMap);
    select({1, 2, 0});
    dragBy(handle({Kind::Vertex, 2, 0}), {7, 6});
    QTRY_COMPARE(steps(), 1);
    QCOMPARE(code().maps.size(), std::size_t{3});
    QVERIFY(code().maps[0] == before.maps[0] && code().maps[1] == before.maps[1]);
    QVERIFY(code().maps[2].map.linear != before.maps[2].map.linear);
}

// Also in a file that was saved and opened again.
void RealBranchTest::aBranchIsShownElsewhereAndPutBack() {
    const document::Fractal before = fractal();
    pick(bar().edit(), document::BranchEdit::Display);
    select({2, 1, 0});
    QVERIFY(!bar().putBackButton()->isVisible());
    const QPoint corner = handle({Kind::Vertex, 0, 0});
    dragBy(corner, {40, -30});
    QTRY_COMPARE(steps(), 1);
    QVERIFY(document::isSameSystem(fractal(), before));
    QCOMPARE(document::plane(fractal())->moved.size(), std::size_t{1});
    const std::vector<document::MovedBranch<2>> moved = document::plane(fractal())->moved;
    hand().key("Control+s");
    QTRY_VERIFY(!window().isWindowModified());

    QVERIFY(window().openPath(m_path));
    QCOMPARE(document::plane(fractal())->moved.size(), std::size_t{1});
    QVERIFY((document::plane(fractal())->moved[0].change.linear - moved[0].change.linear).norm() < 1e-12);
    QTRY_VERIFY(bar().putBackButton()->isVisible());
    click(bar().putBackButton());
    QTRY_VERIFY(document::plane(fractal())->moved.empty());
    QCOMPARE(steps(), 1);
    QVERIFY(!bar().putBackButton()->isVisible());
}

BARYCAGE_TEST_ON_X(RealBranchTest);

#include "real_branch_test.moc"
