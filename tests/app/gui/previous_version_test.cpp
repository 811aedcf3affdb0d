// SPDX-License-Identifier: MIT
#include "application.h"
#include "desktop/preferences.h"
#include "document/disk/process_lock.h"
#include "files/open_claim.h"
#include "main_window.h"
#include "session/session.h"
#include "support/commands.h"
#include "support/named_test.h"
#include "support/own_settings.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QKeySequence>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <sys/stat.h>
#include <unistd.h>

#include <memory>

namespace {

const QByteArray firstVersion = "leaf { .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 1 .5 }\n";

QByteArray bytesOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void putBytes(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) qFatal("no test file");
}

// Renames the fractal and saves; what the window says of it.
QString saveAs(MainWindow& window, const QString& name) {
    document::Fractal changed = window.document().fractal();
    changed.name = name;
    window.document().edit(QStringLiteral("rename"), changed);
    for (QAction* action : window.findChildren<QAction*>())
        if (action->shortcut() == QKeySequence(QKeySequence::Save)) action->trigger();
    return window.statusBar()->currentMessage();
}

// In the dialog that will ask for a file, and in the question whether to replace it.
void answerWith(QTimer& answering, const QString& path) {
    QObject::connect(&answering, &QTimer::timeout, &answering, [path] {
        QWidget* const shown = QApplication::activeModalWidget();
        if (auto* question = qobject_cast<QMessageBox*>(shown)) {
            QPushButton* const yes = qobject_cast<QPushButton*>(question->button(QMessageBox::Yes));
            yes ? yes->click() : question->reject(); // of a folder that is not read yet
        } else if (auto* files = qobject_cast<QFileDialog*>(shown)) {
            files->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(path);
            QMetaObject::invokeMethod(files, "accept", Qt::QueuedConnection);
        }
    });
    answering.start(50);
}

} // namespace

// What saving replaces stays beside the file, and windows know of each other's files.
class PreviousVersionTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        support::useOwnSettings();
        m_folder = std::make_unique<QTemporaryDir>();
        m_path = m_folder->filePath(QStringLiteral("maple.ifs"));
        m_kept = m_path + u'~';
        putBytes(m_path, firstVersion);
    }
    void cleanup() {
        for (SessionWindow* window : session::windows())
            delete window;
    }
    void itIsKeptOnceInASitting();
    void theNextSittingReplacesIt();
    void anotherFileOfThatNameStays();
    void whatIsNoFileStays_data();
    void whatIsNoFileStays();
    void onlyOnesOfOursAreReplaced();
    void nobodyElseReadsIt();
    void behindALinkItIsACopy();
    void nobodyNeedHaveIt();
    void aNewFileHasNone();
    void lessonsKeepTheirs();
    void copiesKeepTheirs();
    void whatIsReplacedByAnotherNameIsKept();
    void aFileOpenElsewhereIsSaid();
    void aClosedWindowGivesItsFileUp();

private:
    MainWindow* opened() {
        auto* window = new MainWindow;
        window->show();
        if (!window->openPath(m_path)) qFatal("not opened");
        return window;
    }
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_path, m_kept;
};

void PreviousVersionTest::itIsKeptOnceInASitting() {
    MainWindow* window = opened();
    const QString said = saveAs(*window, QStringLiteral("one"));
    QVERIFY2(said.contains(QStringLiteral("maple.ifs~")), qPrintable(said));
    QVERIFY(bytesOf(m_path).startsWith("one"));
    QCOMPARE(bytesOf(m_kept), firstVersion);
    QVERIFY(!saveAs(*window, QStringLiteral("two")).contains(u'~'));
    QVERIFY(bytesOf(m_path).startsWith("two"));
    QCOMPARE(bytesOf(m_kept), firstVersion);
}

void PreviousVersionTest::theNextSittingReplacesIt() {
    saveAs(*opened(), QStringLiteral("one"));
    cleanup();
    saveAs(*opened(), QStringLiteral("two"));
    QVERIFY(bytesOf(m_path).startsWith("two"));
    QVERIFY(bytesOf(m_kept).startsWith("one"));
}

void PreviousVersionTest::anotherFileOfThatNameStays() {
    putBytes(m_kept, "theirs");
    const QString said = saveAs(*opened(), QStringLiteral("one"));
    QVERIFY2(said.contains(QStringLiteral("not kept")), qPrintable(said));
    QVERIFY(bytesOf(m_path).startsWith("one"));
    QCOMPARE(bytesOf(m_kept), QByteArray("theirs"));
}

void PreviousVersionTest::whatIsNoFileStays_data() {
    QTest::addColumn<QByteArray>("kind");
    for (const char* kind : {"folder", "dangling link", "link to the file", "pipe", "hard link"})
        QTest::newRow(kind) << QByteArray(kind);
}

void PreviousVersionTest::whatIsNoFileStays() {
    QFETCH(const QByteArray, kind);
    const QByteArray name = QFile::encodeName(m_kept), file = QFile::encodeName(m_path);
    int made = -1;
    if (kind == "folder") made = ::mkdir(name.constData(), 0700);
    if (kind == "dangling link") made = ::symlink("nowhere", name.constData());
    if (kind == "link to the file") made = ::symlink("maple.ifs", name.constData());
    if (kind == "pipe") made = ::mkfifo(name.constData(), 0600);
    if (kind == "hard link") made = ::link(file.constData(), name.constData());
    QCOMPARE(made, 0);
    struct stat before {
    }, after{};
    QCOMPARE(::lstat(name.constData(), &before), 0);
    const QString said = saveAs(*opened(), QStringLiteral("one"));
    QVERIFY(bytesOf(m_path).startsWith("one"));
    QCOMPARE(::lstat(name.constData(), &after), 0);
    QCOMPARE(after.st_ino, before.st_ino);
    QCOMPARE(after.st_mode, before.st_mode);
    if (kind == "hard link") QCOMPARE(bytesOf(m_kept), firstVersion);
    QVERIFY2(said.contains(QStringLiteral("not kept")) == (kind != "hard link"), qPrintable(said));
    QVERIFY(!QFile::exists(m_folder->filePath(QStringLiteral("nowhere"))));
}

// It was ours, and somebody has changed it since, or put a link in its place.
void PreviousVersionTest::onlyOnesOfOursAreReplaced() {
    saveAs(*opened(), QStringLiteral("one"));
    putBytes(m_kept, "theirs");
    cleanup();
    saveAs(*opened(), QStringLiteral("two"));
    QCOMPARE(bytesOf(m_kept), QByteArray("theirs"));
    const QString other = m_folder->filePath(QStringLiteral("other"));
    putBytes(other, firstVersion);
    QVERIFY(QFile::remove(m_kept) && QFile::link(other, m_kept));
    cleanup();
    saveAs(*opened(), QStringLiteral("three"));
    QVERIFY(QFileInfo(m_kept).isSymLink());
    QCOMPARE(bytesOf(other), firstVersion);
}

void PreviousVersionTest::nobodyElseReadsIt() {
    QCOMPARE(::chmod(QFile::encodeName(m_path).constData(), 0600), 0);
    saveAs(*opened(), QStringLiteral("one"));
    for (const QString& path : {m_path, m_kept}) {
        struct stat status {};
        QCOMPARE(::stat(QFile::encodeName(path).constData(), &status), 0);
        QCOMPARE(status.st_mode & 07777, 0600U);
    }
}

void PreviousVersionTest::behindALinkItIsACopy() {
    const QString real = m_folder->filePath(QStringLiteral("real.ifs"));
    QVERIFY(QFile::rename(m_path, real) && QFile::link(real, m_path));
    QCOMPARE(::chmod(QFile::encodeName(real).constData(), 0640), 0);
    saveAs(*opened(), QStringLiteral("one"));
    QVERIFY(QFileInfo(m_path).isSymLink());
    QVERIFY(bytesOf(real).startsWith("one"));
    QVERIFY(!QFileInfo(m_kept).isSymLink());
    QCOMPARE(bytesOf(m_kept), firstVersion);
    struct stat status {};
    QCOMPARE(::stat(QFile::encodeName(m_kept).constData(), &status), 0);
    QCOMPARE(status.st_mode & 07777, 0640U);
}

void PreviousVersionTest::nobodyNeedHaveIt() {
    view::Preferences preferences;
    QVERIFY(preferences.keepPrevious);
    preferences.keepPrevious = false;
    preferences.store();
    saveAs(*opened(), QStringLiteral("one"));
    QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files), QStringList{QStringLiteral("maple.ifs")});
}

void PreviousVersionTest::aNewFileHasNone() {
    MainWindow* window = opened();
    const QString fresh = m_folder->filePath(QStringLiteral("fresh.ifs"));
    QVERIFY(!window->file().saveAs(fresh));
    QVERIFY(!saveAs(*window, QStringLiteral("one")).contains(u'~'));
    QVERIFY(bytesOf(fresh).startsWith("one"));
    QVERIFY(!QFile::exists(fresh + u'~'));
}

// As the file itself: once in a sitting.
void PreviousVersionTest::lessonsKeepTheirs() {
    const QString path = m_folder->filePath(QStringLiteral("my.lesson"));
    const QByteArray first = "lesson: Mine\nfile: maple.ifs\n\n## One\nentry: leaf\n\nText.\n";
    putBytes(path, first);
    auto* window = new MainWindow;
    window->show();
    QVERIFY(window->openPath(path));
    for (const char* title : {"Second", "Third"}) {
        support::command(*window, "add")->trigger();
        support::command(*window, "save-lesson")->trigger();
        QVERIFY2(bytesOf(path) != first, title);
        QCOMPARE(bytesOf(path + u'~'), first);
        const QString said = window->statusBar()->currentMessage();
        QCOMPARE(said.contains(QStringLiteral("my.lesson~")), title == QByteArray("Second"));
    }
}

void PreviousVersionTest::copiesKeepTheirs() {
    const QString path = m_folder->filePath(QStringLiteral("copy.ifs"));
    const QByteArray before = "older { .5 0 0 .5 0 0 1 }\n";
    putBytes(path, before);
    MainWindow* window = opened();
    for (const bool isFirst : {true, false}) {
        QTimer answering;
        answerWith(answering, path);
        support::command(*window, "save-for-other-programs")->trigger();
        answering.stop();
        QVERIFY(bytesOf(path).startsWith("leaf"));
        QCOMPARE(bytesOf(path + u'~'), before);
        const QString said = window->statusBar()->currentMessage();
        QVERIFY2(said.contains(QStringLiteral("copy.ifs~")) == isFirst, qPrintable(said));
    }
    QCOMPARE(bytesOf(m_path), firstVersion);
}

void PreviousVersionTest::whatIsReplacedByAnotherNameIsKept() {
    const QString other = m_folder->filePath(QStringLiteral("other.ifs"));
    const QByteArray before = "older { .5 0 0 .5 0 0 1 }\n";
    putBytes(other, before);
    QVERIFY(!opened()->file().saveAs(other));
    QVERIFY(bytesOf(other).startsWith("leaf"));
    QCOMPARE(bytesOf(other + u'~'), before);
    QVERIFY(!QFile::exists(m_kept));
}

void PreviousVersionTest::aFileOpenElsewhereIsSaid() {
    QVERIFY(QDir().mkpath(QFileInfo(claimOf(m_path)).path()));
    const auto other = document::processLock(claimOf(m_path)); // as another process has it
    QVERIFY(other);
    MainWindow* window = opened();
    QTRY_VERIFY2(window->statusBar()->currentMessage().contains(QStringLiteral("in another window")),
                 qPrintable(window->statusBar()->currentMessage()));
}

void PreviousVersionTest::aClosedWindowGivesItsFileUp() {
    MainWindow* window = opened();
    QTRY_VERIFY(QFile::exists(document::lockFileOf(claimOf(m_path))));
    QCOMPARE(saveAs(*window, QStringLiteral("one")).contains(QStringLiteral("another window")), false);
    cleanup();
    QTRY_VERIFY(!QFile::exists(document::lockFileOf(claimOf(m_path))));
    QVERIFY(QDir(QFileInfo(claimOf(m_path)).path()).isEmpty());
}

BARYCAGE_TEST(PreviousVersionTest, Application);

#include "previous_version_test.moc"
