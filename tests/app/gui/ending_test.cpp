// SPDX-License-Identifier: MIT
#include "application.h"
#include "document/background/background_threads.h"
#include "files/recovery.h"
#include "io/file/background.h"
#include "main_window.h"
#include "support/named_test.h"
#include "support/own_settings.h"

#include <QAction>
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>
#include <QTimer>

#include <semaphore>

namespace {

// As many reads as there are cores twice over, which never answer.
void hang() {
    static std::counting_semaphore<> never(0), begun(0);
    const int count = 2 * QThread::idealThreadCount();
    for (int i = 0; i < count; ++i)
        io::inBackground<void>(io::Lane::Reading, [](QPromise<void>&) {
            begun.release();
            never.acquire();
        });
    for (int i = 0; i < count; ++i)
        begun.acquire();
}

// The program, in which reads hang; its window is changed, saved to `path` and closed.
int edit(int argc, char** argv, const QString& path) {
    {
        Application application(argc, argv);
        support::useOwnSettings();
        auto* window = new MainWindow;
        window->openPath(path);
        window->show();
        hang();
        QTimer::singleShot(0, window, [window] {
            document::Fractal changed = window->document().fractal();
            changed.name = QStringLiteral("mine");
            window->document().edit(QStringLiteral("rename"), changed);
            for (QAction* action : window->findChildren<QAction*>())
                if (action->shortcut() == QKeySequence(QKeySequence::Save)) action->trigger();
            window->close();
        });
        Application::exec();
    }
    if (!document::backgroundFinishes(std::chrono::milliseconds(0))) document::quickExit(7);
    return 1; // nothing hung
}

} // namespace

class EndingTest : public QObject {
    Q_OBJECT

private slots:
    void theProgramSavesAndEndsWhileReadsHang() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("a.ifs"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("leaf { .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 1 .5 }\n");
        file.close();
        QProcess program;
        program.setProcessChannelMode(QProcess::ForwardedChannels);
        program.start(QCoreApplication::applicationFilePath(),
                      {QStringLiteral("ending_test"), QStringLiteral("--edit"), path});
        const bool hasEnded = program.waitForFinished(60'000);
        if (!hasEnded) program.kill();
        program.waitForFinished();
        QVERIFY(hasEnded);
        QCOMPARE(program.exitStatus(), QProcess::NormalExit);
        QCOMPARE(program.exitCode(), 7);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().startsWith("mine {"));
        support::useOwnSettings();
        const QStringList left = QDir(Recovery::folder()).entryList(QDir::Files | QDir::Hidden);
        QVERIFY2(left.isEmpty(), qPrintable(left.join(u' ')));
    }
};

static int runEnding(int argc, char** argv) {
    if (argc > 2 && qstrcmp(argv[1], "--edit") == 0) return edit(argc, argv, QFile::decodeName(argv[2]));
    Application application(argc, argv);
    EndingTest test;
    return QTest::qExec(&test, argc, argv);
}

static const support::NamedTest namedEnding(__FILE__, runEnding);

#include "ending_test.moc"
