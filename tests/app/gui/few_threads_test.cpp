// SPDX-License-Identifier: MIT
#include "application.h"
#include "document/background/background_threads.h"
#include "main_window.h"
#include "session/session.h"
#include "shortage.h"
#include "support/events.h"
#include "support/named_test.h"
#include "support/own_settings.h"
#include "support/paths.h"

#include <QAction>
#include <QDirIterator>
#include <QFile>
#include <QMessageBox>
#include <QProcess>
#include <QProcessEnvironment>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

namespace {

constexpr int longestWait = 60'000;
const QByteArray noThreadSentence = "The system does not let Barycage start another thread.";

QMessageBox* boxOnScreen() {
    for (QWidget* widget : QApplication::topLevelWidgets())
        if (auto* box = qobject_cast<QMessageBox*>(widget); box && box->isVisible()) return box;
    return nullptr;
}

QAction* action(const MainWindow& window, const QKeySequence& shortcut) {
    for (QAction* each : window.findChildren<QAction*>())
        if (each->shortcut() == shortcut) return each;
    return nullptr;
}

// Unsaved work in a program that gets no thread any more. What does not hold: the number of the line.
int goesOnWithoutThreads(MainWindow* window) {
    QFile since(qEnvironmentVariable("BARYCAGE_NO_THREADS_SINCE"));
    if (!since.open(QIODevice::WriteOnly)) return __LINE__;
    QAction* const newWindow = action(*window, QKeySequence(QStringLiteral("Ctrl+Shift+N")));
    for (int i = 0; i < 2; ++i) { // no less the second time
        QMetaObject::invokeMethod(newWindow, &QAction::trigger, Qt::QueuedConnection);
        if (!QTest::qWaitFor([] { return boxOnScreen() != nullptr; }, longestWait)) return __LINE__;
        if (!boxOnScreen()->text().toUtf8().startsWith(noThreadSentence)) return __LINE__;
        boxOnScreen()->accept();
        if (!QTest::qWaitFor([] { return !boxOnScreen(); }, longestWait)) return __LINE__;
    }
    if (session::windows() != QList<SessionWindow*>{window}) return __LINE__;
    QImage large(3000, 3000, QImage::Format_ARGB32);
    large.fill(Qt::red); // Qt scales it with the threads of its global pool
    if (large.scaled(2000, 2000, Qt::IgnoreAspectRatio, Qt::SmoothTransformation).pixelColor(9, 9) != Qt::red)
        return __LINE__;
    action(*window, QKeySequence::Save)->trigger();
    if (!QTest::qWaitFor([window] { return !window->document().isModified(); }, longestWait)) return __LINE__;
    window->close();
    return QTest::qWaitFor([] { return session::allAreClosed(); }, longestWait) ? 0 : __LINE__;
}

int editWithoutThreads(int argc, char** argv, const QString& path) {
    shortage::watchThreads();
    Application application(argc, argv);
    shortage::startThreads();
    shortage::everythingHasStarted();
    support::useOwnSettings();
    auto* window = new MainWindow;
    window->openPath(path);
    window->show();
    document::Fractal changed = window->document().fractal();
    changed.name = QStringLiteral("mine");
    window->document().edit(QStringLiteral("rename"), changed);
    if (const int line = goesOnWithoutThreads(window)) document::quickExit(line);
    return 0;
}

} // namespace

// A limit on processes. Neither the program nor Qt waits for a thread that was not started.
class FewThreadsTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        QFile file(path("a.ifs"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("leaf { .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 1 .5 }\n");
    }
    void theProgramStartsOrSaysWhy();
    void aWindowThatCannotBeOpenedIsSaid();

private:
    QString path(const char* name) const { return m_folder->filePath(QString::fromLatin1(name)); }
    void start(QProcess& process, const QStringList& command, const QString& variable, const QString& value) {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("HOME"), m_folder->path());
        environment.insert(QStringLiteral("LD_PRELOAD"),
                           support::buildPath(QStringLiteral("tests/support/libfew_threads.so")));
        environment.insert(variable, value);
        environment.insert(QStringLiteral("ASAN_OPTIONS"), environment.value(QStringLiteral("ASAN_OPTIONS")) +
                                                               QStringLiteral(":verify_asan_link_order=0"));
        process.setProcessEnvironment(environment);
        process.start(command.first(), command.sliced(1));
        QVERIFY(process.waitForStarted(longestWait));
    }
    // The window has read the file.
    bool isOpen() const {
        QDirIterator files(m_folder->path(), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
        while (files.hasNext())
            if (files.next().contains(QStringLiteral(".open"))) return true;
        return false;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void FewThreadsTest::theProgramStartsOrSaysWhy() {
    int opened = 0, refused = 0;
    for (int most = 0; opened < 2; ++most) {
        init();
        QProcess process;
        start(process, {support::buildPath(QStringLiteral("barycage")), path("a.ifs")},
              QStringLiteral("BARYCAGE_THREADS"), QString::number(most));
        QByteArray said;
        const auto isDecided = [&] {
            said += process.readAllStandardError();
            return process.state() == QProcess::NotRunning || said.contains(noThreadSentence) || isOpen();
        };
        const bool isAnswered = QTest::qWaitFor(isDecided, longestWait);
        const bool hasOpened = isOpen() && !said.contains(noThreadSentence);
        if (!hasOpened) process.waitForFinished(100); // unless a message box waits
        const bool hasEnded = process.state() == QProcess::NotRunning;
        process.kill();
        process.waitForFinished();
        const QByteArray what = QByteArray::number(most) + " threads: " + said;
        QVERIFY2(isAnswered, what.constData());
        QVERIFY2(hasOpened || said.contains("barycage: error: " + noThreadSentence), what.constData());
        if (hasEnded && !hasOpened) QCOMPARE(process.exitCode(), 3);
        (hasOpened ? opened : refused)++;
        QVERIFY2(most < 200, what.constData());
    }
    QVERIFY(refused > 5);
}

void FewThreadsTest::aWindowThatCannotBeOpenedIsSaid() {
    QProcess process;
    process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    start(process,
          {QCoreApplication::applicationFilePath(), QStringLiteral("few_threads_test"),
           QStringLiteral("--edit"), path("a.ifs")},
          QStringLiteral("BARYCAGE_NO_THREADS_SINCE"), path("since"));
    const bool hasEnded = process.waitForFinished(2 * longestWait);
    process.kill();
    process.waitForFinished();
    QVERIFY(hasEnded);
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 0);
    QFile file(path("a.ifs"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.readAll().startsWith("mine {"));
}

static int runFewThreads(int argc, char** argv) {
    if (argc > 2 && qstrcmp(argv[1], "--edit") == 0)
        return editWithoutThreads(argc, argv, QFile::decodeName(argv[2]));
    Application application(argc, argv);
    FewThreadsTest test;
    return QTest::qExec(&test, argc, argv);
}

static const support::NamedTest namedFewThreads(__FILE__, runFewThreads);

#include "few_threads_test.moc"
