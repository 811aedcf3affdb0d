// SPDX-License-Identifier: MIT
#include "bars/branch_bar.h"
#include "document/edits/maps/map_locks.h"
#include "document/fractal/fractal_geometry.h"
#include "ifs/system/branch.h"
#include "support/named_test.h"
#include "view/canvas/canvas_fixture.h"

#include <QSignalSpy>
#include <QSlider>

#include <array>

// Maps that are locked stay where they are, whatever is tried on the canvas, and it says why.
class LockedMapsTest : public CanvasFixture {
    Q_OBJECT

    QPointF middle(int map) const { return at({Kind::Inside, 0, map}); }
    void lock(std::size_t index) {
        const std::array ids{system().maps[index].id};
        document::lockMaps(*m_document, ids, true);
    }
    QString said() const { return m_said->isEmpty() ? QString() : m_said->last().first().toString(); }

private slots:
    void init() {
        open();
        m_canvas->setTool(CanvasView::Tool::Maps);
        lock(1);
        m_code = system();
        m_said = std::make_unique<QSignalSpy>(m_canvas.get(), &CanvasView::message);
    }
    void cleanup() {
        m_said.reset();
        close();
    }

    void dragsAndNudgesAreRefused() {
        drag(middle(1), {30, 20});
        QVERIFY(system() == m_code);
        QCOMPARE(said(), QStringLiteral("Map 2 is locked. Unlock it in the Maps panel first."));
        m_said->clear();
        drag(at({Kind::Vertex, 0, 1}), {30, 20});
        QVERIFY(system() == m_code && !said().isEmpty());
        m_said->clear();
        click(middle(1));
        key(Qt::Key_Right);
        QVERIFY(system() == m_code && !said().isEmpty());
        m_said->clear();
        key(Qt::Key_Delete);
        QVERIFY(system() == m_code && !said().isEmpty());
        QCOMPARE(steps(), 1); // the lock
        drag(middle(0), {30, 20});
        QVERIFY(!(system().maps[0] == m_code.maps[0]));
        QCOMPARE(steps(), 2);
    }

    // Their corners are muted, and no knobs turn or scale what cannot be moved.
    void handlesShowIt() {
        QVERIFY(scene().frames()[1].isLocked && !scene().frames()[0].isLocked);
        m_canvas->selectMaps({system().maps[1].id});
        QVERIFY(!scene().handles().isAnythingHeld());
        hover(at({Kind::Vertex, 0, 1}));
        QCOMPARE(cursor(), Qt::CrossCursor); // no hand
        m_canvas->selectMaps({system().maps[0].id, system().maps[1].id});
        QVERIFY(scene().handles().isAnythingHeld());
        m_document->undoStack()->undo();
        QVERIFY(!scene().frames()[1].isLocked);
    }

    // Of a selection, the others move.
    void theOthersMove() {
        m_canvas->selectMaps({system().maps[0].id, system().maps[1].id});
        drag(middle(0), {30, 20});
        QVERIFY(!(system().maps[0] == m_code.maps[0]));
        QVERIFY(system().maps[1] == m_code.maps[1]);
        QCOMPARE(undoText().section(u':', 0, 0).left(10), QStringLiteral("Move map 1"));
    }

    void weavingLeavesThemAlone() {
        view::BranchBar bar(m_document.get(), m_canvas.get());
        m_canvas->selectMaps({system().maps[1].id});
        bar.swing()->setValue(10);
        QVERIFY(system() == m_code && !said().isEmpty());
        QCOMPARE(bar.swing()->value(), 0);
        m_canvas->selectMaps({system().maps[0].id, system().maps[1].id});
        bar.swing()->setValue(10);
        QVERIFY(!(system().maps[0] == m_code.maps[0]));
        QVERIFY(system().maps[1] == m_code.maps[1]);
    }

    // Where a branch is shown may change; its maps may not.
    void branchesOfLockedMaps() {
        m_canvas->setTool(CanvasView::Tool::Branch);
        auto& tool = m_canvas->tools().branchTool().choice();
        tool.setDepth(1);
        for (const auto edit : {document::BranchEdit::OwnMap, document::BranchEdit::LastMap}) {
            tool.setEdit(edit);
            selectBranch(1);
            m_said->clear();
            drag(m_corner, {25, 10});
            QVERIFY(system() == m_code);
            QVERIFY2(said().contains(QStringLiteral("locked")), qPrintable(said()));
        }
        tool.setEdit(document::BranchEdit::Display);
        selectBranch(1);
        drag(m_corner, {25, 10});
        QVERIFY(system() == m_code);
        QCOMPARE(document::plane(m_document->fractal())->moved.size(), std::size_t(1));
    }

private:
    // By a point of it.
    void selectBranch(int map) {
        const auto point = ifs::addressPoint<2>(ifs::mapsOf(system()), {map, 2, 1}, {0, 2});
        QVERIFY(point);
        click(view::pixelOf(m_canvas->camera(), document::placement(m_document->fractal())(*point)));
        m_corner = at({Kind::Vertex, 0, 0});
        QCOMPARE(m_canvas->tools().branchTool().choice().address().front(), map);
    }

    document::System2 m_code;
    std::unique_ptr<QSignalSpy> m_said;
    QPointF m_corner;
};

BARYCAGE_TEST(LockedMapsTest, QApplication);
#include "locked_maps_test.moc"
