// SPDX-License-Identifier: MIT
#include "app/gui/choose_file.h"
#include "app/gui/session_fixture.h"
#include "panels/lesson/lesson_notebook.h"
#include "support/commands.h"
#include "support/named_test.h"

#include <QAction>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

// How many files a lesson asks for.
class LessonSavingTest : public SessionFixture {
    Q_OBJECT

private slots:
    void aNewLessonAsksForOneFile();
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
}

BARYCAGE_TEST(LessonSavingTest, QApplication);
#include "lesson_saving_test.moc"
