// SPDX-License-Identifier: MIT
#include "app/gui/choose_file.h"
#include "app/gui/session_fixture.h"
#include "document/fractal/fractal.h"
#include "panels/collection/collection_panel.h"
#include "panels/lesson/lesson_notebook.h"
#include "support/commands.h"
#include "support/named_test.h"

#include <QAction>
#include <QDockWidget>
#include <QFile>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>

// How many files a lesson asks for.
class LessonSavingTest : public SessionFixture {
    Q_OBJECT

private slots:
    void aNewLessonAsksForOneFile();
    void savingTheFileSavesTheLesson();
    void anOpenedLessonShowsItsFirstEntry();
    void theCollectionReplacesNothingThatALessonShows();
    void stepsFollowTheNamesOfTheirEntries();
};

// The fractals, which have no file yet, are saved beside it, and over nothing.
void LessonSavingTest::aNewLessonAsksForOneFile() {
    MainWindow* window = shown({});
    const auto command = [window](const char* id) { return support::command(*window, id); };
    auto* notebook = window->findChild<view::LessonNotebook*>();
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("mine.lesson"));
    QFile taken(folder.filePath(QStringLiteral("mine.ifs")));
    QVERIFY(taken.open(QIODevice::WriteOnly));
    taken.write("other {\n .5 0 0 .5 0 0 1\n}\n");
    taken.close();
    QVERIFY(window->path().isEmpty() && notebook);
    command("add")->trigger();
    int dialogs = 0;
    const QWidget* last = nullptr;
    QTimer counting;
    connect(&counting, &QTimer::timeout, this, [&] {
        const auto* files = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
        dialogs += files != nullptr && files != last;
        if (files != nullptr) last = files;
    });
    counting.start(5);
    QTimer answering;
    support::chooseFile(answering, path);
    command("save-lesson")->trigger();
    answering.stop();
    QCOMPARE(dialogs, 1);
    QCOMPARE(window->path(), folder.filePath(QStringLiteral("mine-2.ifs")));
    QVERIFY(QFile::exists(window->path()) && !notebook->isModified());
    QFile saved(path);
    QVERIFY(saved.open(QIODevice::ReadOnly) && taken.open(QIODevice::ReadOnly));
    QVERIFY(saved.readAll().contains("\nfile: mine-2.ifs\n"));
    QVERIFY(taken.readAll().startsWith("other {"));
    QVERIFY(window->statusBar()->currentMessage().contains(QStringLiteral("mine.lesson")) &&
            window->statusBar()->currentMessage().contains(QStringLiteral("mine-2.ifs")));
}

// Who presses Ctrl+S in the text of a lesson means the lesson.
void LessonSavingTest::savingTheFileSavesTheLesson() {
    MainWindow* window = shown({});
    const auto command = [window](const char* id) { return support::command(*window, id); };
    auto* notebook = window->findChild<view::LessonNotebook*>();
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("mine.lesson"));
    const auto* dock = window->findChild<QDockWidget*>(QStringLiteral("lesson"));
    command("add")->trigger();
    QVERIFY(dock->windowTitle().endsWith(u'*'));
    {
        QTimer answering;
        support::chooseFile(answering, folder.filePath(QStringLiteral("mine.ifs")));
        command("save")->trigger();
    }
    QVERIFY(notebook->isModified()); // nobody has said where it belongs
    QVERIFY(window->statusBar()->currentMessage().contains(
        MainWindow::tr("The lesson is not saved yet: choose Save Lesson.")));
    {
        QTimer answering;
        support::chooseFile(answering, path);
        command("save-lesson")->trigger();
    }
    QVERIFY(!notebook->isModified() && !dock->windowTitle().endsWith(u'*'));
    notebook->setText(QStringLiteral("These words are not lost"));
    QVERIFY(notebook->isModified());
    command("save")->trigger();
    QVERIFY(!notebook->isModified());
    QFile saved(path);
    QVERIFY(saved.open(QIODevice::ReadOnly) && saved.readAll().contains("These words are not lost"));
}

// The step that is marked in the list is what the canvas shows.
void LessonSavingTest::anOpenedLessonShowsItsFirstEntry() {
    const QTemporaryDir folder;
    const auto write = [&folder](const char* name, const QByteArray& text) {
        QFile file(folder.filePath(QLatin1String(name)));
        return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
    };
    QVERIFY(write("two.ifs", "first {\n .5 0 0 .5 0 0 1\n .5 0 0 .5 .5 0 1\n}\n"
                             "second {\n .4 0 0 .4 0 0 1\n .4 0 0 .4 .5 0 1\n}\n"));
    MainWindow* window = shown(folder.filePath(QStringLiteral("two.ifs")));
    auto* notebook = window->findChild<view::LessonNotebook*>();
    window->document().setCurrent(window->document().file().entries.last().id);
    support::command(*window, "add")->trigger();
    QTimer answering;
    support::chooseFile(answering, folder.filePath(QStringLiteral("two.lesson")));
    support::command(*window, "save-lesson")->trigger();
    answering.stop();
    QVERIFY(!notebook->isModified());
    window->document().setCurrent(window->document().file().entries.first().id);
    QVERIFY(window->openPath(folder.filePath(QStringLiteral("two.lesson"))));
    QCOMPARE(window->document().fractal().name, QStringLiteral("second"));
    QVERIFY(!window->document().isModified());
}

void LessonSavingTest::theCollectionReplacesNothingThatALessonShows() {
    MainWindow* window = shown({});
    const QString first = window->document().fractal().name;
    support::command(*window, "add")->trigger();
    document::Fractal other = document::sierpinskiTriangle();
    other.name = QStringLiteral("from the collection");
    document::plane(other)->system.maps.front().map.linear *= 0.9;
    emit window->findChild<view::CollectionPanel*>()->chosen({other});
    QCOMPARE(window->document().file().entries.size(), 2);
    QCOMPARE(window->document().file().entries.first().fractal->name, first);
    window->document().undoStack()->setClean();
    window->findChild<view::LessonNotebook*>()->history()->setClean();
}

// Also while the name is being typed, which is no step of the lesson.
void LessonSavingTest::stepsFollowTheNamesOfTheirEntries() {
    MainWindow* window = shown({});
    support::command(*window, "add")->trigger();
    auto* notebook = window->findChild<view::LessonNotebook*>();
    const QString before = window->document().fractal().name;
    const auto shownEntry = [notebook] { return notebook->lesson().steps.first().state.entry; };
    QCOMPARE(shownEntry(), before);
    {
        document::EditGesture typing = window->document().beginGesture(QStringLiteral("Rename"));
        document::Fractal renamed = window->document().fractal();
        for (const char* name : {"b", "blo", "bloom"}) {
            renamed.name = QLatin1String(name);
            typing.preview(renamed);
            QCOMPARE(shownEntry(), before);
        }
        typing.commit();
    }
    QCOMPARE(shownEntry(), QStringLiteral("bloom"));
    QCOMPARE(notebook->history()->count(), 1); // the step was added
    notebook->history()->undo();
    notebook->history()->redo();
    QCOMPARE(shownEntry(), QStringLiteral("bloom"));
    window->document().undoStack()->undo();
    QCOMPARE(shownEntry(), before);
    window->document().undoStack()->setClean();
    notebook->history()->setClean();
}

BARYCAGE_TEST(LessonSavingTest, QApplication);
#include "lesson_saving_test.moc"
