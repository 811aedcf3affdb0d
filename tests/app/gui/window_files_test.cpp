// SPDX-License-Identifier: MIT
#include "application.h"
#include "document/background/background_threads.h"
#include "files/recovery.h"
#include "main_window.h"
#include "panels/entries/entries_model.h"
#include "panels/entries/entries_panel.h"
#include "session/session.h"
#include "support/background_rest.h"
#include "support/file_size_limit.h"
#include "support/named.h"
#include "support/named_test.h"
#include "support/own_settings.h"
#include "support/patient_tries.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMessageBox>
#include <QPointer>
#include <QPrintPreviewDialog>
#include <QProcess>
#include <QProgressDialog>
#include <QScopeGuard>
#include <QSemaphore>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTimer>
#include <QUndoStack>

#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <utility>

namespace {

const QByteArray twoEntries = "one { .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5 }\n\nother { .5 0 0 .5 0 0 1 }\n";

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void put(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) qFatal("no test file");
}

void rename(MainWindow* window, const QString& name) {
    document::Fractal changed = window->document().fractal();
    changed.name = name;
    window->document().edit(QStringLiteral("rename"), changed);
}

void trigger(MainWindow* window, QKeySequence::StandardKey key) {
    for (QAction* action : window->findChildren<QAction*>())
        if (action->shortcut() == QKeySequence(key)) return action->trigger();
    qFatal("no such action");
}

// For recovery.
document::Snapshot kept() {
    const QDir folder(Recovery::folder());
    for (const QString& name : folder.entryList({QStringLiteral("*.journal")}, QDir::Files))
        if (const auto snapshot = document::snapshotIn(contents(folder.filePath(name)))) return *snapshot;
    return {};
}

enum class Answer { Here, Cancel };

// Saves, and answers the question that comes; its title, or nothing when none came.
QString saveAnswering(MainWindow* window, Answer answer) {
    QString asked;
    QTimer answering;
    QObject::connect(&answering, &QTimer::timeout, &answering, [&] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (!box) return;
        asked = box->windowTitle();
        (answer == Answer::Here ? support::button(*box, "here") : box->button(QMessageBox::Cancel))->click();
    });
    answering.start(10);
    trigger(window, QKeySequence::Save);
    return asked;
}

// No message appears while everything works.
bool saysThatWorkIsNotKept(const MainWindow* window) {
    for (const QLabel* label : window->statusBar()->findChildren<QLabel*>())
        if (label->text().contains(QStringLiteral("not yet kept"))) return label->isVisible();
    qFatal("no such label");
}

QSemaphore diskAnswers;
std::atomic<bool> isDiskSlow = false;

} // namespace

// What the journal ends with: here the disk is as slow as a test wants it, and not as it is.
extern "C" __attribute__((visibility("default"))) int fdatasync(int /*file*/) {
    if (isDiskSlow) diskAnswers.acquire();
    return 0;
}

// What becomes of files: saved by others too, gone, killed in between.
class WindowFilesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        support::useOwnSettings();
        QApplication::setQuitOnLastWindowClosed(false);
    }
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_path = m_folder->filePath(QStringLiteral("two.ifs"));
        put(m_path, twoEntries);
    }
    void cleanup() {
        for (SessionWindow* window : session::windows())
            delete window;
        QDir(Recovery::folder()).removeRecursively();
    }

    void aFileChangedElsewhereIsAskedAbout();
    void aFileDeletedElsewhereIsAskedAbout();
    void hardLinksAreSaidToKeepTheOld();
    void twoWindowsDoNotOverwriteEachOther();
    void recoveredWorkDoesNotOverwriteOthers();
    void recoveredWorkKeepsThePathOfAFileThatIsGone();
    void recoveredWorkStaysUntilItIsKept();
    void unsavedWorkIsKeptWithinTwoSeconds();
    void whatIsBeingTypedIsKept();
    void aSlowDiskIsSaid();
    void aFullDiskIsSaidUntilThereIsRoom();
    void manyEntriesOnOneLineAreKeptInTime();
    void whatIsGivenUpIsNotKept();
    void aWindowGoesWithUnsavedWork();
    void aPathIsKnownFromEveryFolder();
    void namesAreNoMarkup();
    void aKilledEditorLeavesItsWork();
    void damagedWorkIsSaidOnce();
    void aPipeIsNotOpened();
    void aLargeFileIsReadBesideTheWindow();
    void aLargeFileIsSavedBesideTheWindow();
    void aWindowMayCloseWhileItDrawsForPaper();

private:
    MainWindow* opened() {
        auto* window = new MainWindow;
        if (!window->openPath(m_path)) qFatal("not opened");
        window->show();
        return window;
    }
    document::Abandoned abandoned() const { // with the second entry renamed
        document::Snapshot snapshot;
        snapshot.path = m_path;
        snapshot.title = QStringLiteral("two.ifs");
        snapshot.bytes = QByteArray(twoEntries).replace("other", "mine");
        snapshot.base = QCryptographicHash::hash(twoEntries, QCryptographicHash::Sha256);
        return {m_folder->filePath(QStringLiteral("old.journal")), snapshot, {}};
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_path;
};

void WindowFilesTest::aFileChangedElsewhereIsAskedAbout() {
    MainWindow* window = opened();
    rename(window, QStringLiteral("mine"));
    const QByteArray theirs = twoEntries + "third { .5 0 0 .5 0 0 1 }\n";
    put(m_path, theirs);
    QCOMPARE(saveAnswering(window, Answer::Cancel), QStringLiteral("Changed on disk"));
    QCOMPARE(contents(m_path), theirs);
    QVERIFY(window->document().isModified());
    QCOMPARE(saveAnswering(window, Answer::Here), QStringLiteral("Changed on disk"));
    QVERIFY(contents(m_path).startsWith("mine"));
    QVERIFY(!contents(m_path).contains("third"));
    rename(window, QStringLiteral("again"));
    QCOMPARE(saveAnswering(window, Answer::Cancel), QString()); // it is ours now
    QVERIFY(contents(m_path).startsWith("again"));
}

void WindowFilesTest::aFileDeletedElsewhereIsAskedAbout() {
    MainWindow* window = opened();
    rename(window, QStringLiteral("mine"));
    QVERIFY(QFile::remove(m_path));
    QCOMPARE(saveAnswering(window, Answer::Cancel), QStringLiteral("Missing on disk"));
    QVERIFY(!QFileInfo::exists(m_path));
    QVERIFY(window->document().isModified());
    QCOMPARE(saveAnswering(window, Answer::Here), QStringLiteral("Missing on disk"));
    QVERIFY(contents(m_path).startsWith("mine"));
    rename(window, QStringLiteral("again"));
    QCOMPARE(saveAnswering(window, Answer::Cancel), QString());
    QVERIFY(contents(m_path).startsWith("again"));
}

// As in a backup that holds what has not changed since by a second name.
void WindowFilesTest::hardLinksAreSaidToKeepTheOld() {
    const QString backup = m_folder->filePath(QStringLiteral("backup.ifs"));
    QCOMPARE(::link(QFile::encodeName(m_path).constData(), QFile::encodeName(backup).constData()), 0);
    MainWindow* window = opened();
    rename(window, QStringLiteral("mine"));
    QCOMPARE(saveAnswering(window, Answer::Cancel), QString());
    QVERIFY(window->statusBar()->currentMessage().contains(QStringLiteral("hard links")));
    QCOMPARE(contents(backup), twoEntries);
    QVERIFY(contents(m_path).startsWith("mine"));
    rename(window, QStringLiteral("again"));
    QCOMPARE(saveAnswering(window, Answer::Cancel), QString());
    QVERIFY(!window->statusBar()->currentMessage().contains(QStringLiteral("hard links")));
}

void WindowFilesTest::twoWindowsDoNotOverwriteEachOther() {
    MainWindow* first = opened();
    MainWindow* second = opened();
    rename(first, QStringLiteral("a"));
    rename(second, QStringLiteral("b"));
    QCOMPARE(saveAnswering(first, Answer::Cancel), QString());
    QCOMPARE(saveAnswering(second, Answer::Cancel), QStringLiteral("Changed on disk"));
    QVERIFY(contents(m_path).startsWith("a"));
}

void WindowFilesTest::recoveredWorkDoesNotOverwriteOthers() {
    const QByteArray theirs = twoEntries + "third { .5 0 0 .5 0 0 1 }\n";
    put(m_path, theirs);
    auto* window = new MainWindow;
    window->openRecovered(abandoned());
    window->show();
    QCOMPARE(window->path(), m_path);
    const auto* entries = window->findChild<view::EntriesPanel*>()->findChild<QListView*>()->model();
    QCOMPARE(entries->rowCount(), 2);
    QVERIFY(!entries->index(0, 0).data(view::EntriesModel::ModifiedRole).toBool()); // it was not edited
    QVERIFY(entries->index(1, 0).data(view::EntriesModel::ModifiedRole).toBool());
    QCOMPARE(saveAnswering(window, Answer::Cancel), QStringLiteral("Changed on disk"));
    QCOMPARE(contents(m_path), theirs);

    put(m_path, twoEntries); // no other program changed it
    auto* other = new MainWindow;
    other->openRecovered(abandoned());
    QCOMPARE(saveAnswering(other, Answer::Cancel), QString());
    QCOMPARE(contents(m_path), abandoned().snapshot.bytes);
}

void WindowFilesTest::recoveredWorkKeepsThePathOfAFileThatIsGone() {
    QFile::remove(m_path);
    auto* window = new MainWindow;
    window->openRecovered(abandoned());
    QCOMPARE(window->path(), m_path);
    QCOMPARE(window->document().file().entries.size(), 2);
    const auto boxes = window->findChildren<QMessageBox*>();
    QCOMPARE(boxes.size(), 1); // and a message says so
    QVERIFY(boxes.first()->text().contains(QStringLiteral("two.ifs")));
    boxes.first()->close();
    QCOMPARE(saveAnswering(window, Answer::Cancel), QString());
    QCOMPARE(contents(m_path), abandoned().snapshot.bytes);
}

// A limit on the size of files simulates a full disk.
void WindowFilesTest::recoveredWorkStaysUntilItIsKept() {
    const document::Abandoned old = abandoned();
    put(old.journal, document::recoveryFile(old.snapshot));
    support::FileSizeLimit limit(64);
    QVERIFY(limit.isSet());
    auto* window = new MainWindow;
    window->openRecovered(old);
    const bool isSaid = QTest::qWaitFor( // that it cannot be kept
        [&] {
            const auto boxes = window->findChildren<QMessageBox*>();
            return std::ranges::any_of(boxes, [](const QMessageBox* box) {
                return box->text().contains(QStringLiteral("Recovery Unavailable"));
            });
        },
        60'000);
    const bool stayed = QFileInfo::exists(old.journal);
    limit.lift();
    QVERIFY(isSaid && stayed);
    QTRY_VERIFY(!QFileInfo::exists(old.journal)); // it is kept as this window's now
    QVERIFY(!QDir(Recovery::folder()).entryList({QStringLiteral("*.journal")}, QDir::Files).isEmpty());
}

void WindowFilesTest::unsavedWorkIsKeptWithinTwoSeconds() {
    MainWindow* window = opened();
    rename(window, QStringLiteral("mine"));
    QTRY_VERIFY(kept().bytes.startsWith("mine"));
    QCOMPARE(kept().path, m_path);
    QCOMPARE(kept().base, QCryptographicHash::hash(twoEntries, QCryptographicHash::Sha256));
    window->document().undoStack()->undo();
    QTRY_VERIFY(kept().bytes.isEmpty()); // nothing is unsaved any more
}

void WindowFilesTest::whatIsBeingTypedIsKept() {
    MainWindow* window = opened();
    auto* panel = window->findChild<view::EntriesPanel*>();
    panel->renameCurrent();
    auto* editor = panel->findChild<QListView*>()->findChild<QLineEdit*>();
    QVERIFY(editor);
    QTest::keyClicks(editor, QStringLiteral("half"));
    QTRY_VERIFY(kept().bytes.startsWith("half"));
    QTest::keyClick(editor, Qt::Key_Escape);
    QTRY_VERIFY(kept().bytes.isEmpty());
    panel->editComment();
    auto* dialog = panel->findChild<QDialog*>();
    QVERIFY(dialog);
    dialog->findChild<QLineEdit*>()->setText(QStringLiteral("half a comment"));
    QTRY_VERIFY(kept().bytes.contains("half a comment"));
    dialog->reject();
    QTRY_VERIFY(kept().bytes.isEmpty());
}

// One write hangs for longer than two seconds; the edits meanwhile are behind as well, until they are kept.
void WindowFilesTest::aSlowDiskIsSaid() {
    MainWindow* window = opened();
    QVERIFY(!saysThatWorkIsNotKept(window));
    const auto answer = qScopeGuard([] {
        isDiskSlow = false;
        diskAnswers.release(10);
    });
    isDiskSlow = true;
    QElapsedTimer sinceEdit;
    sinceEdit.start();
    rename(window, QStringLiteral("mine"));
    QTRY_VERIFY_WITH_TIMEOUT(saysThatWorkIsNotKept(window), 60'000);
    QVERIFY(sinceEdit.elapsed() >= 2000);
    rename(window, QStringLiteral("again"));
    // So that it waits for the first, and is late itself: nothing more is said than before.
    QTest::qWait(2100);
    QVERIFY(saysThatWorkIsNotKept(window));
    isDiskSlow = false;
    diskAnswers.release();
    QTRY_VERIFY_WITH_TIMEOUT(!saysThatWorkIsNotKept(window), 60'000);
    QVERIFY(kept().bytes.startsWith("again"));
    isDiskSlow = true;
    rename(window, QStringLiteral("once more"));
    QTRY_VERIFY_WITH_TIMEOUT(saysThatWorkIsNotKept(window), 60'000);
    window->document().undoStack()->undo();
    window->document().undoStack()->undo();
    QVERIFY(saysThatWorkIsNotKept(window));
    window->document().undoStack()->undo();
    QVERIFY(!saysThatWorkIsNotKept(window)); // nothing is unsaved any more
}

// A limit on the size of files simulates it.
void WindowFilesTest::aFullDiskIsSaidUntilThereIsRoom() {
    MainWindow* window = opened();
    support::FileSizeLimit limit(64);
    QVERIFY(limit.isSet());
    rename(window, QStringLiteral("mine"));
    QTRY_VERIFY_WITH_TIMEOUT(saysThatWorkIsNotKept(window), 60'000);
    limit.lift();
    QTRY_VERIFY_WITH_TIMEOUT(!saysThatWorkIsNotKept(window), 60'000);
    QVERIFY(kept().bytes.startsWith("mine"));
}

void WindowFilesTest::manyEntriesOnOneLineAreKeptInTime() {
    QByteArray line;
    for (int i = 0; i < 100'000; ++i)
        line += 'e' + QByteArray::number(i) + " { .5 0 0 .5 0 0 1 .5 0 0 .5 1 0 1 } ";
    put(m_path, line);
    MainWindow* window = opened();
    rename(window, QStringLiteral("mine"));
    QTRY_COMPARE_WITH_TIMEOUT(kept().bytes, QByteArray(line).replace(0, 2, "mine"), 60'000);
}

// The other windows may still be asking about theirs.
void WindowFilesTest::whatIsGivenUpIsNotKept() {
    document::Document document;
    const OpenFile file(&document, nullptr);
    Recovery recovery(&document, &file, nullptr);
    const QDir folder(Recovery::folder());
    const auto journals = [&] { return folder.entryList({QStringLiteral("*.journal")}, QDir::Files).size(); };
    const auto edit = [&](const char* name) {
        document::Fractal changed = document.fractal();
        changed.name = QString::fromUtf8(name);
        document.edit(QStringLiteral("rename"), changed);
    };
    edit("mine");
    QTRY_COMPARE(journals(), 1);
    recovery.giveUp();
    QTRY_COMPARE(journals(), 0);
    edit("still mine");
    document::Document another;
    const OpenFile anotherFile(&another, nullptr);
    const Recovery other(&another, &anotherFile, nullptr);
    document::Fractal renamed = another.fractal();
    renamed.name = QStringLiteral("another");
    another.edit(QStringLiteral("rename"), renamed);
    QTRY_COMPARE(journals(), 1); // its own
    QVERIFY(support::backgroundRests());
    QCOMPARE(journals(), 1);
    QVERIFY(kept().bytes.startsWith("another"));
}

// The history is emptied after the file has gone that the title names.
void WindowFilesTest::aWindowGoesWithUnsavedWork() {
    class Listener : public QObject {
    public:
        int count = 0;
        bool eventFilter(QObject*, QEvent* event) override {
            count += event->type() == QEvent::ModifiedChange ? 1 : 0;
            return false;
        }
    } listener;
    MainWindow* window = opened();
    window->installEventFilter(&listener);
    rename(window, QStringLiteral("mine"));
    const int before = std::exchange(listener.count, 0);
    QVERIFY(before > 0);
    delete window;
    QCOMPARE(listener.count, 0);
}

void WindowFilesTest::aPathIsKnownFromEveryFolder() {
    const QString before = QDir::currentPath();
    QVERIFY(QDir::setCurrent(m_folder->path()));
    auto* window = new MainWindow;
    const bool isOpen = window->openPath(QStringLiteral("two.ifs"));
    QVERIFY(QDir::setCurrent(before));
    QVERIFY(isOpen);
    QCOMPARE(QFileInfo(window->path()).canonicalFilePath(), QFileInfo(m_path).canonicalFilePath());
    QVERIFY(QFileInfo(window->path()).isAbsolute());
}

// Qt would read the picture, whatever that may be.
void WindowFilesTest::namesAreNoMarkup() {
    MainWindow* window = opened();
    QVERIFY(!window->openPath(m_folder->filePath(QStringLiteral("<img src=pipe>.ifs"))));
    auto* box = window->findChild<QMessageBox*>();
    QVERIFY(box);
    QVERIFY(box->text().contains(QStringLiteral("<img src=pipe>")));
    const auto labels = box->findChildren<QLabel*>();
    QVERIFY(labels.size() >= 2);
    for (const QLabel* label : labels)
        QCOMPARE(label->textFormat(), Qt::PlainText);
    box->close();
    document::Fractal changed = window->document().fractal();
    changed.name = QStringLiteral("other");
    window->document().edit(QStringLiteral("Rename “<img src=pipe>”"), changed);
    for (const QAction* action : window->findChildren<QAction*>())
        QVERIFY2(!action->toolTip().contains(QStringLiteral("<img")), qPrintable(action->toolTip()));
}

// This program again, as the editor, killed after it has said that its work is changed.
void WindowFilesTest::aKilledEditorLeavesItsWork() {
    QProcess editor;
    editor.start(QCoreApplication::applicationFilePath(),
                 {QStringLiteral("window_files_test"), QStringLiteral("--edit"), m_path});
    QVERIFY(editor.waitForReadyRead(30'000));
    QTRY_VERIFY(kept().bytes.startsWith("killed"));
    editor.kill();
    QVERIFY(editor.waitForFinished());
    const auto found = document::abandonedSnapshots(Recovery::folder());
    QCOMPARE(found.size(), 1);
    QCOMPARE(found.first().snapshot.path, m_path);
    QVERIFY(found.first().snapshot.bytes.startsWith("killed"));
    QVERIFY(document::abandonedSnapshots(Recovery::folder()).isEmpty()); // it is offered once
    document::forget(found.first());
    QCOMPARE(contents(m_path), twoEntries);
}

void WindowFilesTest::damagedWorkIsSaidOnce() {
    QVERIFY(QDir().mkpath(Recovery::folder()));
    const QDir folder(Recovery::folder());
    put(folder.filePath(QStringLiteral("old.journal")), "barycage-journal 1\n{}\nhalf of it");
    QStringList said;
    QTimer answering;
    connect(&answering, &QTimer::timeout, &answering, [&] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (!box) return;
        said << box->informativeText();
        box->close();
    });
    answering.start(10);
    for (int start = 0; start < 2; ++start)
        QVERIFY(Recovery::ask().isEmpty());
    const QString kept = folder.filePath(QStringLiteral("old.damaged"));
    QCOMPARE(said, QStringList{QDir::toNativeSeparators(kept)});
    QVERIFY(contents(kept).endsWith("half of it"));
}

// Reading it would wait for somebody who writes, even after the window is gone.
void WindowFilesTest::aPipeIsNotOpened() {
    MainWindow* window = opened();
    const QString pipe = m_folder->filePath(QStringLiteral("pipe.ifs"));
    QCOMPARE(::mkfifo(QFile::encodeName(pipe).constData(), 0600), 0);
    QVERIFY(!window->openPath(pipe));
    const auto boxes = window->findChildren<QMessageBox*>();
    QCOMPARE(boxes.size(), 1);
    QVERIFY(boxes.front()->informativeText().contains(QLatin1String("not a regular file")) ||
            boxes.front()->text().contains(QLatin1String("not a regular file")));
    boxes.front()->close();
}

// The window lives meanwhile; reading can be cancelled, and then all is as before.
void WindowFilesTest::aLargeFileIsReadBesideTheWindow() {
    MainWindow* window = opened();
    const QString large = m_folder->filePath(QStringLiteral("large.ifs"));
    put(large, QByteArray("many { .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5 }\n").repeated(100'000));
    int seen = 0;
    bool cancelling = true;
    QTimer looking;
    connect(&looking, &QTimer::timeout, &looking, [&] {
        auto* progress = window->findChild<QProgressDialog*>();
        if (!progress) return;
        ++seen;
        if (cancelling) emit progress->canceled();
    });
    looking.start(1);
    QVERIFY(!window->openPath(large));
    QVERIFY(seen > 0);
    QCOMPARE(window->path(), m_path);
    QCOMPARE(window->document().file().entries.size(), 2);
    QCOMPARE(window->findChildren<QMessageBox*>().size(), 1); // a message says so
    window->findChildren<QMessageBox*>().first()->close();
    cancelling = false;
    seen = 0;
    QVERIFY(window->openPath(large));
    QVERIFY(seen > 0);
    QCOMPARE(window->document().file().entries.size(), 100'000);
}

// Cancelling leaves the file as it was, and the work unsaved.
void WindowFilesTest::aLargeFileIsSavedBesideTheWindow() {
    const QByteArray large = QByteArray("many { .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5 }\n").repeated(100'000);
    put(m_path, large);
    MainWindow* window = opened();
    rename(window, QStringLiteral("mine"));
    int seen = 0;
    bool cancelling = true;
    QTimer looking;
    connect(&looking, &QTimer::timeout, &looking, [&] {
        auto* progress = window->findChild<QProgressDialog*>();
        if (!progress || !progress->labelText().startsWith(QStringLiteral("Saving"))) return;
        ++seen;
        QVERIFY(!window->close());
        if (cancelling) emit progress->canceled();
    });
    looking.start(1);
    trigger(window, QKeySequence::Save);
    QVERIFY(seen > 0);
    QCOMPARE(contents(m_path), large);
    QVERIFY(window->document().isModified());
    QCOMPARE(window->findChildren<QMessageBox*>().size(), 1); // a message says so
    window->findChildren<QMessageBox*>().first()->close();
    cancelling = false;
    trigger(window, QKeySequence::Save);
    QVERIFY(contents(m_path).startsWith("mine {"));
    QVERIFY(!window->document().isModified());
    QTRY_COMPARE(QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden),
                 QStringList({QStringLiteral("two.ifs"), QStringLiteral("two.ifs~")}));
}

void WindowFilesTest::aWindowMayCloseWhileItDrawsForPaper() {
    const QPointer<MainWindow> window = opened();
    QVERIFY(document::backgroundFinishes(std::chrono::seconds(30)));
    QSemaphore gate;
    for (int i = 0; i < document::threadsOfLane; ++i) // too busy to begin
        document::startInLane(document::Lane::Computing, [&gate] { gate.acquire(); });
    QTimer closing;
    connect(&closing, &QTimer::timeout, &closing, [&] {
        if (!window->findChild<QProgressDialog*>()) return;
        closing.stop();
        delete window.data();
    });
    closing.start(0);
    trigger(window, QKeySequence::Print);
    QVERIFY(!window);
    gate.release(document::threadsOfLane);
    QVERIFY(document::backgroundFinishes(std::chrono::seconds(30)));
    for (const QWidget* widget : QApplication::topLevelWidgets())
        QVERIFY(!qobject_cast<const QPrintPreviewDialog*>(widget));
}

static int runWindowFiles(int argc, char** argv) {
    Application application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.value(1) == QLatin1String("--edit")) {
        support::useOwnSettings();
        MainWindow window;
        window.openPath(arguments.value(2));
        rename(&window, QStringLiteral("killed"));
        fputs("changed\n", stdout);
        fflush(stdout);
        return QApplication::exec();
    }
    WindowFilesTest test;
    return QTest::qExec(&test, argc, argv);
}

static const support::NamedTest namedWindowFiles(__FILE__, runWindowFiles);

#include "window_files_test.moc"
