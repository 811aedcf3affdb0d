// SPDX-License-Identifier: MIT
#include "app/gui/choose_file.h"
#include "app/gui/window_fixture.h"
#include "document/edits/cage/cage_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "files/recovery.h"
#include "io/lesson/lesson_reader.h"
#include "panels/lesson/lesson_card.h"
#include "panels/lesson/lesson_notebook.h"
#include "panels/lesson/lesson_panel.h"
#include "session/session.h"
#include "space/space_view.h"
#include "support/background_rest.h"
#include "support/commands.h"
#include "support/named.h"
#include "support/named_test.h"

#include <QAction>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QMessageBox>
#include <QPrintPreviewDialog>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolBar>

using namespace Qt::StringLiterals;

// Lessons are recorded, saved beside the file, and played in the presentation, and change nothing in the
// file.
class LessonTest : public WindowFixture {
    Q_OBJECT

private slots:
    void stepsKeepTheStateOfTheWindow();
    void stepsKeepHowAFittedViewIsTurned();
    void playingChangesNothing();
    void editsAreTakenBackAtEveryStep();
    void theTextCoversNothing();
    void theFileIsNotSavedMeanwhile();
    void lessonsAreSavedAndOpened();
    void lessonsMayStandElsewhere();
    void unsavedStepsAreAskedFor();
    void unsavedStepsAreRecovered();
    void fractalsThatAreGoneAreFound();
    void filesThatCannotBePlayed();
    void entriesAndCagesMayBeGone();
    void readyMadeLessonsTakeAWindowOfTheirOwn();
    void theWindowMayCloseMeanwhile();

private:
    document::Document& document() { return m_window->document(); }
    view::CanvasView* canvas() const { return m_window->findChild<view::CanvasView*>(); }
    view::LessonNotebook* notebook() const { return m_window->findChild<view::LessonNotebook*>(); }
    view::LessonCard* card() const { return m_window->findChild<view::LessonCard*>(); }
    QAction* command(const char* id) const { return support::command(*m_window, id); }
    QAction* builtIn(const QString& name) const {
        for (auto* found : m_window->findChildren<QAction*>())
            if (found->data() == name) return found;
        return nullptr;
    }
    QString shownText() const {
        QString all;
        for (const auto* label : card()->findChildren<QLabel*>())
            if (label->isVisible()) all += label->text() + u'\n';
        return all;
    }
    void moveCorner(double by) {
        ifs::ControlCage<2> cage = document::effectiveCage(document().fractal());
        cage.current[0].x() += by;
        document().edit(u"Move"_s,
                        document::withCageMoved(document().fractal(), cage, document::CageMode::Place));
    }
    document::EntryId idOf(const QString& name) {
        for (const auto& entry : document().file().entries)
            if (entry.fractal->name == name) return entry.id;
        return document::EntryId::None;
    }
    void recordThree();
    void answer(QMessageBox::StandardButton button) {
        QTimer::singleShot(100, this, [button] {
            for (QWidget* widget : QApplication::topLevelWidgets())
                if (auto* box = qobject_cast<QMessageBox*>(widget); box && box->isVisible())
                    box->button(button)->click();
        });
    }
    QStringList failures() const {
        QStringList said;
        for (auto* box : m_window->findChildren<QMessageBox*>())
            if (box->isVisible()) {
                said << box->informativeText();
                box->close();
            }
        return said;
    }
};

namespace {

void write(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
}

} // namespace

// One of the maple with its cage moved, one of the flower zoomed in, one of steps.
void LessonTest::recordThree() {
    moveCorner(0.5);
    command("add")->trigger();
    QCOMPARE(m_window->focusWidget()->accessibleName(), u"Title of the step"_s); // what is typed is its text
    notebook()->setStepTitle(u"First"_s);
    notebook()->setText(u"Look at the corner."_s);
    document().undoStack()->undo();
    document().setCurrent(idOf(u"flower"_s));
    canvas()->navigation().zoomBy(3);
    canvas()->setTool(view::CanvasView::Tool::Maps);
    command("add")->trigger();
    notebook()->setText(u"Two maps."_s);
    canvas()->setTool(view::CanvasView::Tool::Cage);
    document().setCurrent(idOf(u"maple"_s));
    auto* construction = m_window->findChild<view::Construction*>();
    construction->setMode(view::Construction::Mode::Steps);
    construction->setStep(2);
    canvas()->options().setGridVisible(false);
    command("add")->trigger();
    notebook()->setText(u"Two steps."_s);
    construction->setMode(view::Construction::Mode::Density);
    canvas()->options().setGridVisible(true);
    QCOMPARE(notebook()->lesson().steps.size(), 3);
    notebook()->setCurrent(0);
}

void LessonTest::stepsKeepTheStateOfTheWindow() {
    recordThree();
    const auto& steps = notebook()->lesson().steps;
    QVERIFY(std::holds_alternative<std::vector<ifs::Vector<2>>>(steps[0].state.cage));
    QCOMPARE(std::get<document::LessonFit>(steps[0].state.view), document::LessonFit());
    QCOMPARE(steps[1].state.entry, u"flower"_s);
    QCOMPARE(steps[1].state.tool, document::LessonTool::Maps);
    QVERIFY(std::holds_alternative<document::LessonArea>(steps[1].state.view));
    QCOMPARE(steps[2].state.construction.iterations, 2);
    QVERIFY(!steps[2].state.showsGrid && steps[1].state.showsGrid);
    // The panel brings the window back into the state, as one step of the history.
    const int before = document().undoStack()->index();
    emit m_window->findChild<view::LessonPanel*>()->showRequested();
    QCOMPARE(document().undoStack()->index(), before + 1);
    QCOMPARE(document::effectiveCage(document().fractal()).current,
             std::get<std::vector<ifs::Vector<2>>>(steps[0].state.cage));
    document().undoStack()->undo();
    document().undoStack()->setClean();
    notebook()->history()->setClean();
}

// Fit leaves the rotation and the direction of y as they are, and the direction from which a solid is seen.
void LessonTest::stepsKeepHowAFittedViewIsTurned() {
    const auto show = [this](int step) {
        notebook()->setCurrent(step);
        emit m_window->findChild<view::LessonPanel*>()->showRequested();
    };
    view::CanvasNavigation& plane = canvas()->navigation();
    plane.rotateBy(30);
    plane.setYAxis(attractor::YAxis::Down);
    plane.fit();
    command("add")->trigger();
    const double turned = plane.rotation();
    QVERIFY(turned != 0);
    plane.resetRotation();
    plane.setYAxis(attractor::YAxis::Up);
    plane.fit();
    command("add")->trigger();
    show(0);
    QCOMPARE(plane.rotation(), turned);
    QCOMPARE(plane.yAxis(), attractor::YAxis::Down);
    QVERIFY(plane.isFitted());
    show(1);
    QCOMPARE(plane.rotation(), 0.0);
    QCOMPARE(plane.yAxis(), attractor::YAxis::Up);

    notebook()->history()->setClean();
    notebook()->open({}, {});
    const QTemporaryDir folder;
    write(folder.filePath(u"a.ifs"_s), "solid (3D) {\n .5 0 0 0 .5 0 0 0 .5 0 0 0 1\n"
                                       " .5 0 0 0 .5 0 0 0 .5 .5 .5 .5 1\n}\n");
    QVERIFY(m_window->openPath(folder.filePath(u"a.ifs"_s)));
    view::SpaceNavigation& space = m_window->findChild<view::SpaceView*>()->navigation();
    const auto lookFrom = [&space](double azimuth) {
        attractor::OrbitCamera camera = space.camera();
        camera.orientation = attractor::orbit(azimuth, 40);
        space.moveTo(camera);
        space.fit();
        return camera.orientation.coeffs();
    };
    const auto first = lookFrom(70);
    command("add")->trigger();
    lookFrom(-20);
    command("play-lesson")->trigger();
    QCOMPARE(space.camera().orientation.coeffs(), first);
    QVERIFY(space.isFitted());
    const auto before = lookFrom(10);
    QVERIFY(before != first);
    QTest::keyClick(m_window.get(), Qt::Key_Escape);
    QCOMPARE(space.camera().orientation.coeffs(), attractor::orbit(-20, 40).coeffs());
    document().undoStack()->setClean();
    notebook()->history()->setClean();
}

void LessonTest::playingChangesNothing() {
    recordThree();
    moveCorner(-0.25); // unsaved work of the author
    document().setCurrent(idOf(u"flower"_s));
    const document::FractalFile file = document().file();
    const int index = document().undoStack()->index();
    const QSize size = m_window->size();
    canvas()->navigation().zoomBy(1.25); // or the view may still be about to be fitted
    const attractor::Camera camera = canvas()->camera();
    auto* maps = m_window->findChild<QDockWidget*>(u"maps"_s);
    auto* bar = m_window->findChild<QToolBar*>(u"construction"_s);

    command("play-lesson")->trigger();
    QTRY_VERIFY(m_window->isFullScreen() && card() && card()->isVisible());
    QVERIFY(maps->isHidden() && !m_window->menuBar()->isVisible());
    QVERIFY(shownText().contains(u"First"_s) && shownText().contains(u"1 of 3"_s));
    QCOMPARE(document().fractal().name, u"maple"_s);
    QCOMPARE(document::effectiveCage(document().fractal()).current,
             std::get<std::vector<ifs::Vector<2>>>(notebook()->lesson().steps[0].state.cage));
    QTest::keyClick(canvas(), Qt::Key_PageDown);
    QCOMPARE(document().fractal().name, u"flower"_s);
    QCOMPARE(canvas()->tool(), view::CanvasView::Tool::Maps);
    const auto area = std::get<document::LessonArea>(notebook()->lesson().steps[1].state.view);
    QTRY_COMPARE(canvas()->camera(),
                 document::cameraOf(area, {canvas()->viewport()->width(), canvas()->viewport()->height()}));
    const auto place = [this] {
        QCoreApplication::processEvents();
        const auto* next = card()->findChild<QPushButton*>(u"next"_s);
        return next->mapTo(m_window.get(), next->rect().bottomRight());
    };
    const QPoint before = place();
    QTest::keyClick(canvas(), Qt::Key_PageDown);
    QCOMPARE(place(), before); // though only this step speaks of the bar
    QVERIFY(bar->isVisible() && !canvas()->options().isGridVisible());
    QTest::keyClick(canvas(), Qt::Key_PageDown); // there is no fourth
    QVERIFY(shownText().contains(u"Two steps."_s));
    QTest::keyClick(canvas(), Qt::Key_PageUp);
    QVERIFY(shownText().contains(u"Two maps."_s));
    QCOMPARE(place(), before);

    QTest::keyClick(canvas(), Qt::Key_Escape);
    QTRY_VERIFY(!m_window->isFullScreen());
    QVERIFY(!card()->isVisible() && m_window->menuBar()->isVisible() && !maps->isHidden());
    QVERIFY(bar->isHidden());
    QVERIFY(document().file() == file);
    QCOMPARE(document().undoStack()->index(), index);
    QCOMPARE(document().fractal().name, u"flower"_s);
    QCOMPARE(canvas()->tool(), view::CanvasView::Tool::Cage);
    QVERIFY(canvas()->options().isGridVisible());
    QTRY_COMPARE(m_window->size(), size);
    QTRY_COMPARE(canvas()->camera().centre, camera.centre);
    document().undoStack()->setClean();
    notebook()->history()->setClean();
}

void LessonTest::editsAreTakenBackAtEveryStep() {
    recordThree();
    document().undoStack()->setClean();
    command("play-lesson")->trigger();
    const document::Fractal shown = document().fractal();
    moveCorner(1);
    moveCorner(1);
    QTest::keyClick(canvas(), Qt::Key_PageDown);
    QTest::keyClick(canvas(), Qt::Key_PageUp);
    QVERIFY(document().fractal() == shown);
    // What the class has made can be had back when the lesson has ended.
    moveCorner(2);
    const document::Fractal made = document().fractal();
    QTest::keyClick(canvas(), Qt::Key_Escape);
    QVERIFY(!document().isModified());
    document().undoStack()->redo();
    document().undoStack()->redo();
    QVERIFY(document().fractal() == made);
    document().undoStack()->setClean();
    // Undo beyond the beginning of the lesson does no harm.
    command("play-lesson")->trigger();
    document().undoStack()->setIndex(0);
    moveCorner(3);
    for (int i = 0; i < 2; ++i) {
        QTest::keyClick(canvas(), Qt::Key_PageDown);
        QTest::keyClick(canvas(), Qt::Key_PageUp);
    }
    QVERIFY(document().undoStack()->count() < 5);
    QTest::keyClick(canvas(), Qt::Key_Escape);
    document().undoStack()->setClean();
    notebook()->history()->setClean();
}

void LessonTest::theTextCoversNothing() {
    auto* analysis = m_window->findChild<QDockWidget*>(u"analysis"_s);
    analysis->show(); // and is there again after the lesson
    recordThree();
    document().undoStack()->setClean();
    command("play-lesson")->trigger();
    QTRY_VERIFY(m_window->isFullScreen() && card()->isVisible());
    const auto global = [](const QWidget* widget) {
        return QRect(widget->mapToGlobal(QPoint()), widget->size());
    };
    QTRY_VERIFY(canvas()->width() + card()->width() <= m_window->width());
    QVERIFY(!global(card()).intersects(global(canvas())));
    QTRY_COMPARE_WITH_TIMEOUT(card()->height() > m_window->height() * 9 / 10, true, 60'000);
    QVERIFY(canvas()->width() > m_window->width() / 2);
    // A step may show panels; the next one need not.
    document::LessonState state = notebook()->lesson().steps[0].state;
    QTest::keyClick(canvas(), Qt::Key_Escape);
    state.panels = {u"analysis"_s, u"nothing-of-this-name"_s};
    notebook()->setState(state);
    command("play-lesson")->trigger();
    QTRY_VERIFY(analysis->isVisible());
    QTest::keyClick(canvas(), Qt::Key_PageDown);
    QVERIFY(analysis->isHidden());
    QTest::keyClick(canvas(), Qt::Key_Escape);
    QTRY_VERIFY(!analysis->isHidden());
    notebook()->history()->setClean();
}

void LessonTest::theFileIsNotSavedMeanwhile() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"a.ifs"_s);
    write(path, "a {\n .5 0 0 .5 0 0 1\n}\n");
    QVERIFY(m_window->openPath(path));
    canvas()->options().setAxesVisible(true);
    command("add")->trigger();
    document::LessonState state = notebook()->lesson().steps[0].state;
    state.colourBy = attractor::ColourBy::Map; // not as in the file
    notebook()->setState(state);
    command("play-lesson")->trigger();
    QVERIFY(document().isModified());
    QTest::keyClick(canvas(), Qt::Key_S, Qt::ControlModifier);
    QVERIFY(canvas()->hint().contains(u"Esc"_s));
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), QByteArray("a {\n .5 0 0 .5 0 0 1\n}\n"));
    QTest::keyClick(canvas(), Qt::Key_Escape);
    QVERIFY(!document().isModified());
    notebook()->history()->setClean();
}

void LessonTest::lessonsAreSavedAndOpened() {
    const QTemporaryDir folder;
    const QString fractals = folder.filePath(u"a.ifs"_s);
    const QString path = folder.filePath(u"my.lesson"_s);
    const QByteArray bytes = "a {\n .5 0 0 .5 0 0 1\n .5 0 0 .5 .5 0 1\n}\nb {\n .4 0 0 .4 0 0 1\n}\n";
    write(fractals, bytes);
    write(path, "lesson: Mine\nfile: a.ifs\n\n## One\nentry: b\n\nText.\n");
    QVERIFY(m_window->openPath(path));
    QCOMPARE(m_window->path(), fractals);
    QCOMPARE(notebook()->lesson().title, u"Mine"_s);
    QVERIFY(!notebook()->isModified() && !document().isModified());
    QVERIFY(m_window->findChild<QDockWidget*>(u"lesson"_s)->isVisible());
    // Saved where it comes from; the fractals are left alone.
    command("add")->trigger();
    notebook()->setText(u"More."_s);
    command("save-lesson")->trigger();
    QVERIFY(!notebook()->isModified());
    QFile saved(path);
    QVERIFY(saved.open(QIODevice::ReadOnly));
    const document::Lesson lesson = io::readLesson(saved.readAll()).lesson;
    QVERIFY(lesson == notebook()->lesson());
    QCOMPARE(lesson.steps.size(), 2);
    QFile untouched(fractals);
    QVERIFY(untouched.open(QIODevice::ReadOnly));
    QCOMPARE(untouched.readAll(), bytes);
    // Another file has another lesson, or none.
    write(folder.filePath(u"b.ifs"_s), "c {\n .5 0 0 .5 0 0 1\n}\n");
    QVERIFY(m_window->openPath(folder.filePath(u"b.ifs"_s)));
    QTRY_VERIFY(notebook()->isEmpty());
}

void LessonTest::lessonsMayStandElsewhere() {
    const QTemporaryDir folder;
    for (const QString& name : {u"course"_s, u"fractals"_s, u"moved"_s})
        QVERIFY(QDir(folder.path()).mkdir(name));
    const QString fractals = folder.filePath(u"fractals/a.ifs"_s);
    const QString path = folder.filePath(u"course/my.lesson"_s);
    write(fractals, "a {\n .5 0 0 .5 0 0 1\n .5 0 0 .5 .5 0 1\n}\n");
    QVERIFY(m_window->openPath(fractals));
    command("add")->trigger();
    {
        QTimer answering;
        support::chooseFile(answering, path);
        command("save-lesson-as")->trigger();
    }
    QVERIFY(!notebook()->isModified());
    QCOMPARE(notebook()->path(), path);
    QFile saved(path);
    QVERIFY(saved.open(QIODevice::ReadOnly));
    QVERIFY(saved.readAll().contains("\nfile: ../fractals/a.ifs\n"));
    // It stays there without another question.
    notebook()->setText(u"More."_s);
    command("save-lesson")->trigger();
    QVERIFY(!notebook()->isModified() && !QFile::exists(folder.filePath(u"fractals/my.lesson"_s)));
    QVERIFY(m_window->openPath(path));
    QCOMPARE(m_window->path(), fractals);
    QCOMPARE(notebook()->lesson().steps.value(0).text, u"More."_s);
    // Both were moved into one folder.
    const QString moved = folder.filePath(u"moved/my.lesson"_s);
    QVERIFY(QFile::rename(path, moved));
    QVERIFY(QFile::rename(fractals, folder.filePath(u"moved/a.ifs"_s)));
    QVERIFY(m_window->openPath(moved));
    QCOMPARE(m_window->path(), folder.filePath(u"moved/a.ifs"_s));
    QVERIFY(!notebook()->isModified());
}

void LessonTest::unsavedStepsAreAskedFor() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"a.ifs"_s);
    write(path, "a {\n .5 0 0 .5 0 0 1\n}\n");
    QVERIFY(m_window->openPath(path));
    command("add")->trigger();
    answer(QMessageBox::Cancel);
    m_window->close();
    QVERIFY(m_window->isVisible());
    // Nothing takes them away unasked.
    QVERIFY(m_window->openPath(path));
    QVERIFY(support::backgroundRests());
    QCOMPARE(notebook()->lesson().steps.size(), 1);
    answer(QMessageBox::Discard);
    m_window->close();
    QVERIFY(!m_window->isVisible());
}

// The fractals have no unsaved changes.
void LessonTest::unsavedStepsAreRecovered() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"a.ifs"_s);
    const auto kept = [&path] { // other programs keep theirs there, too
        const QDir journals(Recovery::folder());
        for (const QString& name : journals.entryList({u"*.journal"_s}, QDir::Files)) {
            QFile file(journals.filePath(name));
            if (!file.open(QIODevice::ReadOnly)) continue;
            const auto snapshot = document::snapshotIn(file.readAll());
            if (snapshot && snapshot->path == path) return *snapshot;
        }
        return document::Snapshot();
    };
    write(path, "a {\n .5 0 0 .5 0 0 1\n}\n");
    QVERIFY(m_window->openPath(path));
    command("add")->trigger();
    notebook()->setText(u"Keep me."_s);
    QTRY_VERIFY_WITH_TIMEOUT(kept().lesson.contains("Keep me."), 60'000);
    const document::Snapshot snapshot = kept();
    QCOMPARE(snapshot.path, path);
    notebook()->history()->setClean();
    QTRY_VERIFY(kept().lesson.isEmpty());

    auto other = std::make_unique<MainWindow>();
    other->setAttribute(Qt::WA_DeleteOnClose, false);
    other->openRecovered({folder.filePath(u"old.journal"_s), snapshot, {}});
    auto* recovered = other->findChild<view::LessonNotebook*>();
    support::handleEvents();
    QCOMPARE(recovered->lesson().steps.size(), 1);
    QCOMPARE(recovered->lesson().steps[0].text, u"Keep me."_s);
    QVERIFY(recovered->isModified());
    QTRY_VERIFY(kept().lesson.contains("Keep me.")); // until it is saved
    other->document().undoStack()->setClean();
    recovered->history()->setClean();
    QTRY_VERIFY(kept().lesson.isEmpty());
}

void LessonTest::fractalsThatAreGoneAreFound() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"a.lesson"_s);
    const QString renamed = folder.filePath(u"renamed.ifs"_s);
    write(renamed, "a {\n .5 0 0 .5 0 0 1\n}\n");
    write(path, "lesson: a\nfile: gone.ifs\n\n## One\n\nText.\n");
    QVERIFY(!m_window->openPath(path));
    QAbstractButton* find = support::button(*m_window, "find");
    QTimer answering;
    support::chooseFile(answering, renamed);
    find->click();
    QTRY_COMPARE(m_window->path(), renamed);
    QTRY_COMPARE(notebook()->lesson().file, u"renamed.ifs"_s);
    QVERIFY(notebook()->isModified() && !document().isModified());
    command("save-lesson")->trigger();
    QVERIFY(!notebook()->isModified());
    QFile saved(path);
    QVERIFY(saved.open(QIODevice::ReadOnly));
    QVERIFY(saved.readAll().contains("file: renamed.ifs\n"));
}

void LessonTest::filesThatCannotBePlayed() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"a.lesson"_s);
    moveCorner(1); // unsaved
    const document::FractalFile before = document().file();
    for (const auto& [bytes, says] :
         {std::pair<QByteArray, QString>{"a {\n .5 0 0 .5 0 0 1\n}\n", u"not a lesson"_s},
          {"lesson: a\nfile: a.ifs\n", u"no steps"_s},
          {"lesson: a\n\n## one\n", u"names no file"_s},
          {"lesson: a\nfile: a.lesson\n\n## one\n", u"names no file"_s},
          {"lesson: a\nfile: ../a.txt\n\n## one\n", u"names no file"_s},
          {"lesson: a\nfile: ../gone/b.ifs\n\n## one\n", u"b.ifs"_s},
          {"lesson: a\nfile: gone.ifs\n\n## one\n", u"gone.ifs"_s}}) {
        write(path, bytes);
        QVERIFY(!m_window->openPath(path));
        const QStringList said = failures();
        QVERIFY2(said.join(u' ').contains(says), qPrintable(said.join(u' ') + u" / "_s + says));
        QVERIFY(document().file() == before && notebook()->isEmpty());
        QTRY_VERIFY(failures().isEmpty());
    }
    QVERIFY(!m_window->openPath(folder.filePath(u"none.lesson"_s)));
    QCOMPARE(failures().size(), 1);
    document().undoStack()->setClean();
}

void LessonTest::entriesAndCagesMayBeGone() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"a.lesson"_s);
    write(folder.filePath(u"a.ifs"_s), "broken {\n 1 2\n}\na {\n .5 0 0 .5 0 0 1\n .5 0 0 .5 .5 0 1\n}\n"
                                       "solid (3D) {\n .5 0 0 0 .5 0 0 0 .5 0 0 0 1\n"
                                       " .5 0 0 0 .5 0 0 0 .5 .5 .5 .5 1\n}\n");
    write(path, "lesson: a\nfile: a.ifs\n\n## 1\nentry: gone\ntool: maps\n\n## 2\nentry: broken\ntool: maps\n"
                "cage: 0 0, 1 0, 0 1\nconstruction: chaos-game 10 speed 5\n\n"
                "## 3\nentry: a\ncage: 0 0, 1 0, 1 1, 0 1\ncolour: map\n\n"
                "## 4\nentry: solid\ncage: 0 0, 1 0, 0 1\nview: area 0 0 1 1\nconstruction: steps 30\n"
                "colour: map\n\n"
                "## 5\nentry: solid\nview: orbit 0 0 0 0 0 0 1 3\ncage: 0 0 0, 2 0 0, 0 2 0, 0 0 2\n\n"
                "## 6\nentry: a\nview: orbit 0 0 0 0 0 0 1 3\nview: area 1e30 1e30 1e-30 1e30\n");
    QVERIFY(m_window->openPath(path));
    command("play-lesson")->trigger();
    QTRY_VERIFY(card()->isVisible());
    QVERIFY(canvas()->hint().contains(u"gone"_s));
    for (int step = 1; step < 6; ++step) {
        QTest::keyClick(m_window.get(), Qt::Key_PageDown);
        support::handleEvents();
        QVERIFY(shownText().contains(u"%1 of 6"_s.arg(step + 1)));
        if (step == 2) {
            QVERIFY(canvas()->hint().contains(u"corners"_s));
            QCOMPARE(document().fractal().appearance.colourBy, attractor::ColourBy::Map);
        }
    }
    QTest::keyClick(m_window.get(), Qt::Key_Escape);
    QTRY_VERIFY(!card()->isVisible());
    QVERIFY(!document().isModified());
}

void LessonTest::readyMadeLessonsTakeAWindowOfTheirOwn() {
    moveCorner(1);
    const document::FractalFile before = document().file();
    builtIn(u"chaos_game"_s)->trigger();
    QCOMPARE(session::windows().size(), 2);
    QVERIFY(document().file() == before && notebook()->isEmpty());
    for (SessionWindow* other : session::windows()) {
        if (other == m_window.get()) continue;
        QTRY_VERIFY(other->isFullScreen());
        auto* text = other->findChild<view::LessonCard*>();
        QVERIFY(text && text->isVisible());
        for (int i = 0; i < 10; ++i)
            QTest::keyClick(other, Qt::Key_PageDown);
        support::handleEvents();
        other->close(); // in the middle of it, and nothing is asked
        QTRY_COMPARE(session::windows().size(), 1);
    }
    document().undoStack()->setClean();
    // An unused window is used.
    m_window->openFirstPicture();
    builtIn(u"maple_triangle"_s)->trigger();
    QCOMPARE(session::windows().size(), 1);
    QVERIFY(card()->isVisible() && shownText().contains(u"1 of 8"_s));
    QVERIFY(command("print-lesson")->isEnabled()); // for those who hold the lesson
    command("print-lesson")->trigger();
    auto* preview = m_window->findChild<QPrintPreviewDialog*>();
    QVERIFY(preview && preview->isVisible() && card()->isVisible());
    preview->close();
    QTest::keyClick(canvas(), Qt::Key_Escape);
    QVERIFY(!document().isModified() && !notebook()->isModified());
}

void LessonTest::theWindowMayCloseMeanwhile() {
    recordThree();
    document().undoStack()->setClean();
    notebook()->history()->setClean();
    command("play-lesson")->trigger();
    QTRY_VERIFY(card()->isVisible());
    moveCorner(1);
    m_window.reset();
    QVERIFY(session::windows().isEmpty());
}

BARYCAGE_TEST(LessonTest, QApplication);
#include "lesson_test.moc"
