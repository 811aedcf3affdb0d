// SPDX-License-Identifier: MIT
#include "app/gui/window_fixture.h"
#include "document/edits/cage/cage_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "panels/lesson/lesson_notebook.h"
#include "support/commands.h"
#include "support/named_test.h"

#include <QAction>
#include <QTest>
#include <QUndoStack>

using namespace Qt::StringLiterals;

// What a lesson leaves in the history of the file.
class LessonHistoryTest : public WindowFixture {
    Q_OBJECT

private slots:
    void nothingOfTheLessonIsOffered();
    void whatOthersChangedIsOffered();
    void whatWasUndoneBeforeIsStillOffered();

private:
    document::Document& document() { return m_window->document(); }
    QUndoStack& history() { return *document().undoStack(); }
    view::CanvasView* canvas() const { return m_window->findChild<view::CanvasView*>(); }
    void trigger(const char* id) { support::command(*m_window, id)->trigger(); }
    void moveCorner(double by) {
        ifs::ControlCage<2> cage = document::effectiveCage(document().fractal());
        cage.current[0].x() += by;
        document().edit(u"Move"_s,
                        document::withCageMoved(document().fractal(), cage, document::CageMode::Place));
    }
    // A lesson whose only step shows another cage than the file has, which is as it was opened.
    void recordMovedCage() {
        moveCorner(0.5);
        trigger("add");
        history().setIndex(0);
        history().setClean();
    }
    void end() {
        QTest::keyClick(canvas(), Qt::Key_Escape);
        m_window->findChild<view::LessonNotebook*>()->history()->setClean();
    }
};

void LessonHistoryTest::nothingOfTheLessonIsOffered() {
    recordMovedCage();
    const document::FractalFile before = document().file();
    trigger("play-lesson");
    QVERIFY(document().file() != before); // the step has moved it
    end();
    QVERIFY(document().file() == before);
    QVERIFY(!history().canRedo());
    QVERIFY(!history().canUndo());
    QVERIFY(!document().isModified() && !m_window->isWindowModified());
}

void LessonHistoryTest::whatOthersChangedIsOffered() {
    recordMovedCage();
    trigger("play-lesson");
    moveCorner(2);
    const document::Fractal made = document().fractal();
    end();
    QVERIFY(history().canRedo() && !document().isModified());
    history().setIndex(history().count());
    QVERIFY(document().fractal() == made);
    history().setClean();
}

void LessonHistoryTest::whatWasUndoneBeforeIsStillOffered() {
    trigger("add");
    moveCorner(1);
    const document::Fractal moved = document().fractal();
    history().undo();
    history().setClean();
    trigger("play-lesson"); // its step shows the file as it is
    end();
    QVERIFY(history().canRedo());
    history().redo();
    QVERIFY(document().fractal() == moved);
    history().setClean();
}

BARYCAGE_TEST(LessonHistoryTest, QApplication);
#include "lesson_history_test.moc"
