// SPDX-License-Identifier: MIT
#include "document/disk/journal.h"
#include "support/named_test.h"
#include "support/paths.h"
#include "support/patient_tries.h"
#include "support/thorough.h"
#include "support/x_input.h"

#include <QApplication>
#include <QDeadlineTimer>
#include <QDir>
#include <QDirIterator>
#include <QElapsedTimer>
#include <QFile>
#include <QGuiApplication>
#include <QImage>
#include <QPixmap>
#include <QProcess>
#include <QScreen>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <utility>

using namespace Qt::StringLiterals;

namespace {

constexpr int bound = 20'000; // milliseconds; an end that waits for the drive never comes

// The program itself, with a home of its own and a drive that stops to answer.
class Program {
public:
    Program() {
        for (const QString& folder : {home(), drive(), path(u"runtime"_s)})
            QDir().mkpath(folder);
        QFile::setPermissions(path(u"runtime"_s), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    }
    ~Program() {
        m_process.kill();
        m_process.waitForFinished();
    }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    QString path(const QString& name) const { return m_folder.filePath(name); }
    QString home() const { return path(u"home"_s); }
    QString drive() const { return path(u"drive"_s); }
    QString put(const QString& name) const {
        QFile file(path(name));
        if (!file.open(QIODevice::WriteOnly) ||
            file.write("leaf { .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 1 .5 }\n") < 0)
            qFatal("no test file");
        return file.fileName();
    }

    // `dead` is what does not answer once it hangs; `calls` the only functions of the system, if not empty.
    void start(const QStringList& arguments, const QString& dead, const QString& calls = {}) {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(u"HOME"_s, home());
        environment.insert(u"XDG_RUNTIME_DIR"_s, path(u"runtime"_s));
        environment.insert(u"LD_PRELOAD"_s, support::buildPath(u"tests/support/libhanging_files.so"_s));
        environment.insert(u"BARYCAGE_HANGING"_s, dead);
        environment.insert(u"BARYCAGE_HANGING_SINCE"_s, path(u"since"_s));
        if (!calls.isEmpty()) environment.insert(u"BARYCAGE_HANGING_CALLS"_s, calls);
        environment.insert(u"ASAN_OPTIONS"_s,
                           environment.value(u"ASAN_OPTIONS"_s) + u":verify_asan_link_order=0"_s);
        m_process.setProcessEnvironment(environment);
        m_process.setProcessChannelMode(QProcess::ForwardedChannels);
        m_process.start(support::buildPath(u"barycage"_s), arguments);
        if (!m_process.waitForStarted(bound)) qFatal("the program does not start");
    }
    void hang() const { // from now on
        QFile since(path(u"since"_s));
        if (!since.open(QIODevice::WriteOnly)) qFatal("nothing hangs");
    }
    QString met() const { // a line for each call that hangs
        QFile file(path(u"since.met"_s));
        return file.open(QIODevice::ReadOnly) ? QString::fromLocal8Bit(file.readAll()) : QString();
    }
    bool hasEnded() const { return m_process.state() == QProcess::NotRunning; }
    void send(int signal) const {
        if (!hasEnded()) ::kill(pid_t(m_process.processId()), signal);
    }
    // The signal that ended it, 0: none; nullopt when it goes on.
    std::optional<int> end() {
        if (!hasEnded() && !m_process.waitForFinished(bound)) return std::nullopt;
        return m_process.exitStatus() == QProcess::CrashExit ? m_process.exitCode() : 0;
    }

    // What it keeps for recovery.
    QString recovery() const {
        QDirIterator files(home(), QDir::Dirs | QDir::Hidden | QDir::NoDotAndDotDot,
                           QDirIterator::Subdirectories);
        while (files.hasNext())
            if (files.next().endsWith(u"/recovery"_s)) return files.filePath();
        return home();
    }
    QStringList kept(const QString& ending) const {
        return QDir(recovery()).entryList({u'*' + ending}, QDir::Files | QDir::Hidden);
    }
    QByteArray journal() const {
        const QStringList names = kept(u".journal"_s);
        if (names.size() != 1) return {};
        QFile file(QDir(recovery()).filePath(names.first()));
        if (!file.open(QIODevice::ReadOnly)) return {};
        const auto snapshot = document::snapshotIn(file.readAll());
        return snapshot ? snapshot->bytes : QByteArray();
    }

private:
    QTemporaryDir m_folder;
    QProcess m_process;
};

} // namespace

// How the program ends while a drive does not answer: soon, with what is unsaved in the journal and without
// locks that are left.
class RealEndingTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        if (const QString obstacle = support::XInput::obstacle(); !obstacle.isEmpty())
            QSKIP(qPrintable(obstacle));
    }
    void init() {
        m_program = std::make_unique<Program>();
        m_hand = std::make_unique<support::XInput>();
    }
    void cleanup() {
        m_hand.reset();
        m_program.reset();
    }

    void signalsStoreWhatIsUnsaved_data() {
        QTest::addColumn<int>("signal");
        QTest::newRow("SIGTERM") << SIGTERM;
        QTest::newRow("SIGINT") << SIGINT;
        QTest::newRow("SIGHUP") << SIGHUP;
    }
    void signalsStoreWhatIsUnsaved() {
        QFETCH(const int, signal);
        m_program->start({m_program->put(u"a.ifs"_s)}, m_program->drive());
        editTwice();
        verifyTheEndBy(signal);
    }
    void whileAFileIsRead() {
        if (!support::isThorough())
            QSKIP("The progress of the other window may take the keyboard: BARYCAGE_ALL");
        const QString alive = m_program->put(u"a.ifs"_s), dead = m_program->put(u"drive/b.ifs"_s);
        m_program->hang();
        m_program->start({alive, dead}, m_program->drive());
        QTRY_VERIFY_WITH_TIMEOUT(m_program->met().contains(u"b.ifs"_s), bound);
        QTRY_VERIFY_WITH_TIMEOUT(m_hand->activeTitle().startsWith(u"Barycage"_s), bound); // the progress
        activate();
        editTwice();
        verifyTheEndBy(SIGTERM);
    }
    // Nobody need cancel the reading first.
    void theProgramIsQuitWhileAFileIsRead() {
        const QString alive = m_program->put(u"a.ifs"_s), dead = m_program->put(u"drive/b.ifs"_s);
        m_program->hang();
        m_program->start({alive, dead}, m_program->drive());
        QTRY_VERIFY_WITH_TIMEOUT(m_program->met().contains(u"b.ifs"_s), bound);
        QTRY_VERIFY_WITH_TIMEOUT(m_hand->activeTitle().startsWith(u"Barycage"_s), bound); // the progress
        activate();
        QTRY_VERIFY_WITH_TIMEOUT(isActive(u"a.ifs"_s), bound);
        QVERIFY(edit({"Control+q"}, [this] { return m_program->hasEnded(); }));
        QCOMPARE(m_program->end(), std::optional(0));
    }
    void othersAreOpenedWhileAFileIsRead() {
        const QString alive = m_program->put(u"a.ifs"_s), dead = m_program->put(u"drive/b.ifs"_s);
        m_program->hang();
        m_program->start({dead, alive}, m_program->drive());
        QVERIFY(edit({"Tab", "Right"}, [this] { return !m_program->journal().isEmpty(); }));
        QVERIFY(m_program->met().contains(u"b.ifs"_s));
        m_program->send(SIGTERM);
        QCOMPARE(m_program->end(), std::optional(SIGTERM));
        QVERIFY(m_program->kept(u".lock"_s).isEmpty());
        QCOMPARE(document::abandonedSnapshots(m_program->recovery()).size(), 1);
    }
    void whileAFileIsSaved() {
        m_program->start({m_program->put(u"drive/a.ifs"_s)}, m_program->drive());
        editTwice();
        m_program->hang();
        QVERIFY(press({"Control+s"}, [this] { return !m_program->met().isEmpty(); }));
        verifyTheEndBy(SIGTERM);
    }
    void whileAPictureIsExported() {
        m_program->start({m_program->put(u"a.ifs"_s)}, m_program->drive(), u"write:pwrite:pwrite64"_s);
        startExport();
        activate();
        editTwice();
        verifyTheEndBy(SIGTERM);
    }
    // The question whether it may is answered.
    void theWindowIsClosedWhileAPictureIsExported() {
        m_program->start({m_program->put(u"a.ifs"_s)}, m_program->drive(), u"write:pwrite:pwrite64"_s);
        startExport();
        activate();
        QTRY_VERIFY_WITH_TIMEOUT(isActive(u"a.ifs"_s), bound);
        QVERIFY(press({"Control+q"}, [this] { return isActive(u"Export is not finished"_s); }));
        QVERIFY(press({"Alt+s"}, [this] { return m_program->hasEnded(); }));
        QCOMPARE(m_program->end(), std::optional(0));
    }
    // What was stored before is still there.
    void whileTheHomeFolderIsDead() {
        m_program->start({m_program->put(u"a.ifs"_s)}, m_program->home());
        editTwice();
        m_program->hang();
        const QByteArray before = m_program->journal();
        m_program->send(SIGTERM);
        QCOMPARE(m_program->end(), std::optional(SIGTERM));
        QVERIFY(!m_program->met().isEmpty());
        QVERIFY(!before.isEmpty());
        QCOMPARE(m_program->journal(), before);
    }
    void theWindowIsClosedWhileTheHomeFolderIsDead() {
        if (!support::isThorough())
            QSKIP("The program waits for its settings for fifteen seconds: BARYCAGE_ALL");
        m_program->start({m_program->put(u"a.ifs"_s)}, m_program->home());
        QTRY_VERIFY_WITH_TIMEOUT(isActive(u"a.ifs"_s), bound);
        m_program->hang();
        QVERIFY(press({"Control+q"}, [this] { return !isActive(u"a.ifs"_s); }));
        QTRY_VERIFY_WITH_TIMEOUT(!m_program->met().isEmpty(), bound);
        std::optional<int> status = m_program->end();
        if (!status) status = m_program->end(); // it is given a while to store its settings
        QCOMPARE(status, std::optional(0));
    }
    void aSecondSignalEndsAtOnce() {
        m_program->start({m_program->put(u"a.ifs"_s)}, m_program->home());
        editTwice();
        m_program->hang();
        m_program->send(SIGTERM);
        const auto endsBySending = [this] { // again, because several at once count as one
            m_program->send(SIGINT);
            return m_program->hasEnded();
        };
        QVERIFY(QTest::qWaitFor(endsBySending, bound));
        QCOMPARE(m_program->end(), std::optional(SIGINT));
    }

private:
    bool isActive(const QString& title) const { return m_hand->activeTitle().contains(title); }
    // The left of the active window, as the screen shows it: the progress of another window may lie over the
    // rest.
    QImage picture() const {
        const QImage whole = QGuiApplication::primaryScreen()->grabWindow(m_hand->activeWindow()).toImage();
        return whole.copy(0, 0, whole.width() / 4, whole.height());
    }
    // Again: a window that opens meanwhile takes the place.
    void activate() {
        const auto isDone = [this] { return m_hand->activate(u"a.ifs"_s) && isActive(u"a.ifs"_s); };
        QVERIFY(QTest::qWaitFor(isDone, bound));
    }
    // Again until it is so: keys are lost while a window is laid out or waits for a file.
    bool press(std::initializer_list<const char*> keys, const std::function<bool()>& isSo) {
        const QDeadlineTimer late(bound);
        while (!late.hasExpired()) {
            for (const char* key : keys)
                m_hand->key(key);
            if (QTest::qWaitFor(isSo)) return true;
        }
        return false;
    }
    // The same in the window of a.ifs: the progress of another one may take its place between two tries.
    bool edit(std::initializer_list<const char*> keys, const std::function<bool()>& isSo) {
        const QDeadlineTimer late(bound);
        while (!late.hasExpired()) {
            activate();
            for (const char* key : keys)
                m_hand->key(key);
            if (QTest::qWaitFor(isSo)) return true;
        }
        return false;
    }
    // The second time nothing of it is in the journal yet.
    void editTwice() {
        QTRY_VERIFY_WITH_TIMEOUT(isActive(u"a.ifs"_s), bound);
        QVERIFY(edit({"Tab", "Right"}, [this] { return !m_program->journal().isEmpty(); }));
        m_first = m_program->journal();
        QImage before;
        QElapsedTimer still;
        const auto isAtRest = [&] {
            if (std::exchange(before, picture()) != before) still.start();
            return still.isValid() && still.hasExpired(500);
        };
        QVERIFY(QTest::qWaitFor(isAtRest, bound));
        QVERIFY(edit({"Right"}, [&] { return picture() != before; }));
    }
    void verifyTheEndBy(int signal) {
        QCOMPARE(m_program->journal(), m_first);
        m_program->send(signal);
        QCOMPARE(m_program->end(), std::optional(signal));
        QVERIFY(!m_first.isEmpty() && !m_program->journal().isEmpty());
        QVERIFY(m_program->journal() != m_first);
        QVERIFY2(m_program->kept(u".lock"_s).isEmpty(), qPrintable(m_program->kept(u".lock"_s).join(u' ')));
        QCOMPARE(document::abandonedSnapshots(m_program->recovery()).size(), 1);
    }
    // Into the drive, which hangs as soon as something is written there.
    void startExport() {
        QTRY_VERIFY_WITH_TIMEOUT(isActive(u"a.ifs"_s), bound);
        QVERIFY(press({"Control+e"}, [this] { return isActive(u"Export “"_s); }));
        QVERIFY(press({"Return"}, [this] { return !isActive(u"Export “"_s); }));
        m_hand->key("Control+a");
        m_hand->type(m_program->drive() + u"/p.png"_s);
        m_program->hang();
        m_hand->key("Return");
        QTRY_VERIFY_WITH_TIMEOUT(m_program->met().contains(u"write"_s), bound);
    }

    std::unique_ptr<Program> m_program;
    std::unique_ptr<support::XInput> m_hand;
    QByteArray m_first; // in the journal
};

BARYCAGE_TEST(RealEndingTest, QApplication);
#include "real_ending_test.moc"
