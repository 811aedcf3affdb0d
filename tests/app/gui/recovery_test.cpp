// SPDX-License-Identifier: MIT
#include "files/recovery.h"

#include "app/gui/window_fixture.h"
#include "io/lesson/lesson_writer.h"
#include "panels/lesson/lesson_notebook.h"
#include "sudden_end.h"
#include "support/named_test.h"

#include <QDir>
#include <QSessionManager>
#include <QTest>
#include <QUndoStack>

#include <array>
#include <chrono>
#include <cstddef>

using namespace Qt::StringLiterals;

// How unsaved work of earlier sessions is offered, and what comes back.
class RecoveryTest : public WindowFixture {
    Q_OBJECT

private slots:
    void workIsListedByName_data();
    void workIsListedByName();
    void aLessonOfATitleOnlyComesBack();
    void workWithoutAFileIsNotUndone();
    void theEndOfASessionStoresIt();
};

namespace {

document::Snapshot work(const QString& path, const QString& title, int minute = 0) {
    document::Snapshot snapshot;
    snapshot.path = path;
    snapshot.title = title;
    snapshot.when = QDateTime(QDate(2026, 11, 28), QTime(9, minute));
    snapshot.bytes = "a { .5 0 0 .5 0 0 1 }\n";
    return snapshot;
}

} // namespace

void RecoveryTest::workIsListedByName_data() {
    QTest::addColumn<QList<document::Snapshot>>("found");
    QTest::addColumn<QStringList>("lines");
    QTest::newRow("one") << QList{work(u"/x/a.ifs"_s, u"a.ifs"_s)}
                         << QStringList{u"a.ifs, 2026-11-28 09:00"_s};
    QTest::newRow("files of one name")
        << QList{work(u"/x/a.ifs"_s, u"a.ifs"_s), work(u"/y/a.ifs"_s, u"a.ifs"_s)}
        << QStringList{u"/x/a.ifs, 2026-11-28 09:00"_s, u"/y/a.ifs, 2026-11-28 09:00"_s};
    QTest::newRow("windows that read alike")
        << QList{work({}, u"Untitled"_s), work({}, u"Untitled"_s), work({}, u"Untitled"_s, 1)}
        << QStringList{u"Untitled, 2026-11-28 09:00 (2 windows)"_s, u"Untitled, 2026-11-28 09:01"_s};
}

void RecoveryTest::workIsListedByName() {
    QFETCH(QList<document::Snapshot>, found);
    QTEST(Recovery::lines(found), "lines");
}

void RecoveryTest::aLessonOfATitleOnlyComesBack() {
    document::Lesson lesson;
    lesson.title = u"Ferns"_s;
    document::Snapshot snapshot = work({}, u"Untitled"_s);
    snapshot.lesson = io::writeLesson(lesson);
    m_window->openRecovered({{}, snapshot, {}});
    const auto* notebook = m_window->findChild<view::LessonNotebook*>();
    QCOMPARE(notebook->lesson().title, u"Ferns"_s);
    QVERIFY(notebook->isModified());
}

// The entries of a new window, which they replaced, were never theirs.
void RecoveryTest::workWithoutAFileIsNotUndone() {
    document::Snapshot snapshot = work({}, u"Untitled"_s);
    snapshot.bytes = "mine { .5 0 0 .5 0 0 1 }\n\nother { .25 0 0 .5 0 0 1 }\n";
    m_window->openRecovered({{}, snapshot, {}});
    document::Document& document = m_window->document();
    QCOMPARE(document.file().entries.size(), 2);
    QVERIFY(!document.undoStack()->canUndo());
    QVERIFY(document.isModified() && m_window->isWindowModified());
    document::Fractal renamed = document.fractal();
    renamed.name = u"yours"_s;
    document.edit(u"Rename"_s, renamed);
    document.undoStack()->undo();
    QCOMPARE(document.file().entries.size(), 2);
    QVERIFY(document.isModified());
    document.undoStack()->setClean();
}

// At once, and the window goes on: the session may stay after all.
void RecoveryTest::theEndOfASessionStoresIt() {
    const QDir folder(Recovery::folder());
    const auto kept = [&] { return folder.entryList({u"*.journal"_s}, QDir::Files); };
    QVERIFY(document::laneFinishes(document::Lane::Saving, std::chrono::minutes(1)));
    const QStringList before = kept();
    const SuddenEnd end;
    document::Fractal changed = m_window->document().fractal();
    changed.name = u"mine"_s;
    m_window->document().edit(u"Rename"_s, changed);
    // Nobody looks at the manager, which only the platform can make.
    alignas(QSessionManager) std::array<std::byte, sizeof(QSessionManager)> manager{};
    emit qApp->commitDataRequest(reinterpret_cast<QSessionManager&>(manager));
    QVERIFY(document::laneFinishes(document::Lane::Saving, std::chrono::minutes(1)));
    QCOMPARE(kept().size(), before.size() + 1);
    QVERIFY(m_window->isVisible() && m_window->document().isModified());
    m_window->document().undoStack()->setClean();
    QTRY_COMPARE(kept(), before);
}

BARYCAGE_TEST(RecoveryTest, QApplication);

#include "recovery_test.moc"
