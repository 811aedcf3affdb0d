// SPDX-License-Identifier: MIT
#include "application.h"
#include "desktop/settings.h"
#include "dialogs/export/export_data_dialog.h"
#include "dialogs/export/export_dialog.h"
#include "document/fractal/fractal_geometry.h"
#include "files/exports.h"
#include "files/recent_files.h"
#include "io/exports/task_folder.h"
#include "io/fractint/entry_writer.h"
#include "main_window.h"
#include "panels/appearance/palettes/gradient_editor.h"
#include "session/session.h"
#include "support/background_rest.h"
#include "support/commands.h"
#include "support/every_window.h"
#include "support/named.h"
#include "support/named_test.h"
#include "support/own_settings.h"
#include "support/patient_tries.h"
#include "support/slow_disk.h"
#include "welcome.h"

#include <QAbstractButton>
#include <QAction>
#include <QCommandLinkButton>
#include <QDeadlineTimer>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QPointer>
#include <QProgressDialog>
#include <QSettings>
#include <QTemporaryDir>
#include <QTimer>
#include <QUndoStack>

#include <functional>

using namespace std::chrono_literals;

namespace {

constexpr auto delay = 150ms; // of each answer: longer than a window waits for one

QStringList shownRecent(const MainWindow& window) {
    for (auto* menu : window.findChildren<QMenu*>())
        if (menu->objectName() == QStringLiteral("recent")) {
            emit menu->aboutToShow();
            QStringList names;
            for (const QAction* action : menu->actions())
                if (action->text().endsWith(QStringLiteral(".ifs"))) names << action->text();
            return names;
        }
    return {};
}

void trigger(const MainWindow& window, const QKeySequence& key) {
    for (QAction* action : window.findChildren<QAction*>())
        if (action->shortcut() == key) return action->trigger();
    qFatal("no such action");
}

} // namespace

// Files may lie on a drive that answers late, or never: no thread of a window asks for them itself.
class SlowDiskTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QApplication::setQuitOnLastWindowClosed(false);
        QVERIFY(m_folder.isValid());
        for (const char* name : {"a.ifs", "b.ifs", "c.ifs"})
            put(name, "leaf { .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 1 .5 }\n");
        put("p.gpl", "GIMP Palette\nName: two\n0 0 0 black\n255 255 255 white\n");
    }
    void init() {
        support::useOwnSettings();
        view::store(QStringLiteral("recentFiles"), QStringList{path("a.ifs"), path("b.ifs"), path("c.ifs")});
        view::store(QStringLiteral("session/files"), QStringList{path("a.ifs")});
        view::store(QStringLiteral("dialogs/folder"), m_folder.path());
        view::finishStoring();
    }
    void cleanup() {
        for (SessionWindow* window : session::windows())
            delete window;
    }

    void theDriveIsSlow();
    void recentFilesAreListed();
    void theMenusAndDialogsOfAFileThere();
    void openingSavingReverting();
    void dialogsThatAskForAFile();
    void palettesAndTables();
    void whatIsGoneIsLeftOutInTheEnd();
    void settingsAreReadAndWritten();
    void aWindowIsClosedWhileItReads();
    void othersAreOpenedMeanwhile();
    void unsavedWorkIsRecoveredMeanwhile();
    void queuedExportsGoOnMeanwhile();
    void manyThatHangAreCancelled();
    void aWindowIsNotClosedWhileItSaves();

private:
    void put(const char* name, const QByteArray& bytes) const {
        QFile file(path(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) qFatal("no test file");
    }
    QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    // Does `act`, and rejects every dialog for a file that comes; how many came.
    static int rejectingDialogs(const std::function<void()>& act) {
        int met = 0;
        QTimer timer;
        connect(&timer, &QTimer::timeout, &timer, [&met] {
            if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
                ++met;
                dialog->reject();
            }
        });
        timer.start(20);
        act();
        return met;
    }

    QTemporaryDir m_folder;
};

#define VERIFY_NOTHING_WAS_ASKED(disk)                                                                       \
    do {                                                                                                     \
        const QStringList noted = (disk).takeNoted();                                                        \
        QVERIFY2(noted.isEmpty(), qPrintable(noted.join(u'\n')));                                            \
    } while (false)

// Otherwise these tests would prove nothing.
void SlowDiskTest::theDriveIsSlow() {
    support::SlowDisk disk(m_folder.path(), delay);
    QVERIFY(QFileInfo::exists(path("a.ifs")));
    QFile file(path("b.ifs"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QStringList noted = disk.takeNoted();
    QVERIFY2(noted.join(u' ').contains(QStringLiteral("a.ifs")), qPrintable(noted.join(u'\n')));
    QVERIFY2(noted.join(u' ').contains(QStringLiteral("open64 ") + path("b.ifs")),
             qPrintable(noted.join(u'\n')));
    QVERIFY(disk.takeNoted().isEmpty());
}

void SlowDiskTest::recentFilesAreListed() {
    support::SlowDisk disk(m_folder.path(), delay);
    MainWindow window;
    window.openFirstPicture();
    window.show();
    QCOMPARE(shownRecent(window).size(), 3);
    Welcome::offer(&window);
    QCOMPARE(window.findChildren<QCommandLinkButton*>().size(), 3);
    QCOMPARE(session::files(), QStringList{path("a.ifs")});
    QVERIFY(disk.waited() > 0); // somebody asked
    VERIFY_NOTHING_WAS_ASKED(disk);
}

void SlowDiskTest::theMenusAndDialogsOfAFileThere() {
    support::SlowDisk disk(m_folder.path(), delay);
    const support::EveryWindow windows(path("a.ifs"));
    QVERIFY(windows.dialogs().size() > 8);
    for (auto* menu : windows.main().findChildren<QMenu*>())
        emit menu->aboutToShow();
    QVERIFY(support::backgroundRests());
    VERIFY_NOTHING_WAS_ASKED(disk);
}

void SlowDiskTest::openingSavingReverting() {
    support::SlowDisk disk(m_folder.path(), delay);
    auto* window = new MainWindow;
    window->show();
    QVERIFY(window->openPath(path("a.ifs")));
    QCOMPARE(window->path(), path("a.ifs"));
    VERIFY_NOTHING_WAS_ASKED(disk);
    document::Fractal changed = window->document().fractal();
    changed.headerComment = QStringLiteral("mine");
    window->document().edit(QStringLiteral("comment"), changed);
    trigger(*window, QKeySequence::Save);
    QVERIFY(!window->document().isModified());
    VERIFY_NOTHING_WAS_ASKED(disk);
    support::command(*window, "revert")->trigger();
    QCOMPARE(window->document().fractal().headerComment, QStringLiteral("mine"));
    VERIFY_NOTHING_WAS_ASKED(disk);
    window->openRecent(path("b.ifs"));
    QCOMPARE(window->path(), path("b.ifs"));
    QVERIFY(!window->openPath(path("none.ifs")));
    window->close();
    VERIFY_NOTHING_WAS_ASKED(disk);
}

void SlowDiskTest::dialogsThatAskForAFile() {
    support::SlowDisk disk(m_folder.path(), delay);
    auto* window = new MainWindow;
    window->show();
    QVERIFY(window->openPath(path("a.ifs")));
    for (const QKeySequence& key :
         {QKeySequence(QKeySequence::Open), QKeySequence(QStringLiteral("Ctrl+Shift+S"))})
        QCOMPARE(rejectingDialogs([&] { trigger(*window, key); }), 1);
    trigger(*window, QKeySequence(QStringLiteral("Ctrl+E")));
    auto* dialog = window->findChild<view::ExportDialog*>();
    QVERIFY(dialog);
    QAbstractButton* choose = support::button(*dialog, "export");
    QCOMPARE(rejectingDialogs([choose] { choose->click(); }), 1);
    VERIFY_NOTHING_WAS_ASKED(disk);
}

void SlowDiskTest::palettesAndTables() {
    support::SlowDisk disk(m_folder.path(), delay);
    document::Document document;
    view::ExportDataDialog data(&document);
    data.show();
    data.exportTo(path("table.csv"));
    VERIFY_NOTHING_WAS_ASKED(disk);
    QVERIFY(QFile::exists(path("table.csv")));
    disk.takeNoted();
    view::GradientEditor editor;
    editor.show();
    QStringList heard;
    connect(&editor, &view::GradientEditor::tried, this, [&heard](const QString& what) { heard << what; });
    editor.load(path("p.gpl"));
    QCOMPARE(heard.size(), 1);
    editor.save(path("mine.gpl"));
    VERIFY_NOTHING_WAS_ASKED(disk);
    QVERIFY(QFile::exists(path("mine.gpl")));
}

void SlowDiskTest::whatIsGoneIsLeftOutInTheEnd() {
    view::store(QStringLiteral("recentFiles"), QStringList{path("a.ifs"), path("gone.ifs")});
    support::SlowDisk disk(m_folder.path(), delay);
    QCOMPARE(recent_files::list().size(), 2);
    QTRY_COMPARE(recent_files::list(), QStringList{path("a.ifs")});
    VERIFY_NOTHING_WAS_ASKED(disk);
}

void SlowDiskTest::settingsAreReadAndWritten() {
    support::SlowDisk disk(QFileInfo(QSettings().fileName()).path(), delay);
    QCOMPARE(view::stored(QStringLiteral("dialogs/folder")).toString(), m_folder.path());
    view::store(QStringLiteral("dialogs/folder"), path("a.ifs"));
    QCOMPARE(view::stored(QStringLiteral("dialogs/folder")).toString(), path("a.ifs"));
    QTRY_VERIFY(disk.waited() > 0);
    disk.answer();
    QVERIFY(view::finishStoring());
    VERIFY_NOTHING_WAS_ASKED(disk);
}

// Without a question or a message, and the next file is not opened in it.
void SlowDiskTest::aWindowIsClosedWhileItReads() {
    support::SlowDisk disk(m_folder.path(), 2s);
    auto* other = new MainWindow;
    other->show();
    const QPointer<MainWindow> window = new MainWindow;
    int questions = 0;
    QTimer closing;
    connect(&closing, &QTimer::timeout, this, [&] {
        if (qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) ++questions;
        if (!window->isVisible()) return;
        QVERIFY(qobject_cast<QProgressDialog*>(QApplication::activeModalWidget()));
        QVERIFY(window->close());
        QVERIFY(!window->isVisible());
    });
    closing.start(300);
    MainWindow::openEach({path("a.ifs")}, window);
    QVERIFY(window && !window->isVisible());
    closing.stop();
    QCOMPARE(questions, 0);
    QTRY_VERIFY(!window);
    QVERIFY(other->isVisible());
}

namespace {

MainWindow* windowOf(const QString& path) {
    for (SessionWindow* window : session::windows())
        if (window->path() == path && window->isVisible()) return qobject_cast<MainWindow*>(window);
    return nullptr;
}

QList<QProgressDialog*> shownProgress() {
    QList<QProgressDialog*> shown;
    for (QWidget* widget : QApplication::topLevelWidgets())
        if (auto* progress = qobject_cast<QProgressDialog*>(widget); progress && progress->isVisible())
            shown << progress;
    return shown;
}

} // namespace

// A file that is not read yet keeps no other one from being opened, and is opened when it is read.
void SlowDiskTest::othersAreOpenedMeanwhile() {
    const QTemporaryDir quick;
    const QString here = quick.filePath(QStringLiteral("quick.ifs"));
    QVERIFY(QFile::copy(path("b.ifs"), here));
    support::SlowDisk disk(m_folder.path(), 20s);
    bool wereMeanwhile = false;
    QTimer looking;
    connect(&looking, &QTimer::timeout, &looking, [&] {
        wereMeanwhile = wereMeanwhile || (windowOf(here) && shownProgress().size() == 2 &&
                                          !windowOf(path("a.ifs")) && !windowOf(path("c.ifs")));
        if (wereMeanwhile) disk.answer();
    });
    looking.start(10);
    MainWindow::openEach({path("a.ifs"), path("c.ifs"), here});
    QVERIFY(wereMeanwhile);
    QVERIFY(shownProgress().isEmpty());
    QVERIFY(windowOf(path("a.ifs")) && windowOf(path("c.ifs")) && windowOf(here));
    QCOMPARE(session::windows().size(), 3);
}

void SlowDiskTest::unsavedWorkIsRecoveredMeanwhile() {
    const QTemporaryDir quick;
    const QString here = quick.filePath(QStringLiteral("quick.ifs"));
    QVERIFY(QFile::copy(path("b.ifs"), here));
    const auto unsaved = [](const QString& of) {
        return WantedFile{of, document::Abandoned{{}, {of, of, 0, {}, "mine { .5 0 0 .5 0 0 1 }\n", {}}, {}}};
    };
    support::SlowDisk disk(m_folder.path(), 20s);
    bool wasMeanwhile = false;
    QTimer looking;
    connect(&looking, &QTimer::timeout, &looking, [&] {
        wasMeanwhile = wasMeanwhile || (windowOf(here) && windowOf(here)->document().isModified() &&
                                        !windowOf(path("a.ifs")));
        if (wasMeanwhile) disk.answer();
    });
    looking.start(10);
    MainWindow::openEach(QList{unsaved(path("a.ifs")), unsaved(here)});
    QVERIFY(wasMeanwhile);
    for (const QString& each : {path("a.ifs"), here}) {
        QVERIFY(windowOf(each));
        QCOMPARE(windowOf(each)->document().fractal().name, QStringLiteral("mine"));
        windowOf(each)->document().undoStack()->undo();
        QCOMPARE(windowOf(each)->document().fractal().name, QStringLiteral("leaf"));
    }
}

// Those that an earlier run has left, for instance one that ended while it read the same file.
void SlowDiskTest::queuedExportsGoOnMeanwhile() {
    const QTemporaryDir quick;
    io::ExportTask task;
    task.path = quick.filePath(QStringLiteral("a.png"));
    task.name = QStringLiteral("sierpinski");
    task.entry = io::writeEntry(document::sierpinskiTriangle());
    io::PixelRecipe recipe;
    recipe.camera.width = recipe.camera.height = 64;
    task.recipe = recipe;
    QVERIFY(io::TaskFolder(exports::folder()).write(io::TaskFolder::newId(), task));
    support::SlowDisk disk(m_folder.path(), 20s);
    bool wasDrawn = false;
    QTimer looking;
    connect(&looking, &QTimer::timeout, &looking, [&] {
        const QList<QProgressDialog*> progress = shownProgress();
        wasDrawn = wasDrawn || (!progress.isEmpty() && QFileInfo::exists(task.path));
        if (wasDrawn && !progress.isEmpty()) emit progress.first()->canceled();
    });
    looking.start(10);
    const QDeadlineTimer late(15s);
    static_cast<Application*>(qApp)->openWindows({path("a.ifs")});
    QVERIFY(wasDrawn && !late.hasExpired());
    exports::queue()->forgetDone();
}

// Each where its window says that it is read, or by closing that.
void SlowDiskTest::manyThatHangAreCancelled() {
    support::SlowDisk disk(m_folder.path(), 20s);
    QTimer cancelling;
    connect(&cancelling, &QTimer::timeout, &cancelling, [] {
        const QList<QProgressDialog*> progress = shownProgress();
        if (progress.size() < 2) return;
        emit progress.first()->canceled();
        progress.last()->parentWidget()->close();
    });
    cancelling.start(10);
    const QDeadlineTimer late(15s);
    MainWindow::openEach({path("a.ifs"), path("c.ifs")});
    QVERIFY(!late.hasExpired());
    QTRY_COMPARE(session::windows().size(), 1);
    QVERIFY(session::windows().front()->path().isEmpty());
    QCOMPARE(session::windows().front()->findChildren<QMessageBox*>().size(), 1); // which says so
}

// What is unsaved stays until it is: the saving is cancelled first, and the work goes elsewhere.
void SlowDiskTest::aWindowIsNotClosedWhileItSaves() {
    auto* window = new MainWindow;
    window->show();
    QVERIFY(window->openPath(path("a.ifs")));
    document::Fractal changed = window->document().fractal();
    changed.name = QStringLiteral("mine");
    window->document().edit(QStringLiteral("rename"), changed);
    support::SlowDisk disk(m_folder.path(), 20s);
    bool wasAsked = false;
    QTimer closing;
    connect(&closing, &QTimer::timeout, &closing, [&] {
        const QList<QProgressDialog*> progress = shownProgress();
        if (progress.isEmpty()) return;
        wasAsked = true;
        QVERIFY(!window->close());
        session::quit();
        QVERIFY(window->isVisible());
        emit progress.first()->canceled();
    });
    closing.start(10);
    const QDeadlineTimer late(15s);
    trigger(*window, QKeySequence::Save);
    QVERIFY(wasAsked && !late.hasExpired());
    closing.stop();
    QVERIFY(window->isVisible() && window->document().isModified());
    const QTemporaryDir quick;
    const QString here = quick.filePath(QStringLiteral("here.ifs"));
    QVERIFY(!window->file().saveAs(here));
    QVERIFY(!window->document().isModified());
    QVERIFY(window->close());
}

BARYCAGE_TEST(SlowDiskTest, Application);

#include "slow_disk_test.moc"
