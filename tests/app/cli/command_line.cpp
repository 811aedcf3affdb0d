// SPDX-License-Identifier: MIT
#include "app/cli/command_line.h"
#include "attractor/kernels/kernels.h"
#include "run.h"
#include "support/paths.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QProcess>
#include <QTest>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <string>
#include <sys/mman.h>
#include <unistd.h>
#include <vector>

namespace {

// A standard stream of the process, replaced by a file without a name while this lives.
class ReplacedStream {
public:
    ReplacedStream(int stream, const QByteArray& bytes = {})
        : m_stream(stream), m_kept(::dup(stream)), m_file(::memfd_create("stream", 0)) {
        const bool isWritten = ::write(m_file, bytes.constData(), std::size_t(bytes.size())) == bytes.size();
        m_isReplaced = isWritten && ::lseek(m_file, 0, SEEK_SET) == 0 && ::dup2(m_file, m_stream) >= 0;
    }
    ReplacedStream(const ReplacedStream&) = delete;
    ReplacedStream& operator=(const ReplacedStream&) = delete;
    ~ReplacedStream() {
        ::dup2(m_kept, m_stream);
        ::close(m_kept);
        ::close(m_file);
    }

    bool isReplaced() const { return m_isReplaced; }

    QByteArray bytes() const {
        QFile file;
        if (::lseek(m_file, 0, SEEK_SET) != 0 || !file.open(m_file, QIODevice::ReadOnly)) return {};
        return file.readAll();
    }

private:
    int m_stream, m_kept, m_file;
    bool m_isReplaced = false;
};

// What a call may change of the process, put back when this ends.
class ProcessState {
public:
    explicit ProcessState(const QString& folder) {
        pthread_sigmask(SIG_SETMASK, nullptr, &m_signals);
        QDir::setCurrent(folder);
        m_handler = qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});
    }
    ProcessState(const ProcessState&) = delete;
    ProcessState& operator=(const ProcessState&) = delete;
    ~ProcessState() {
        qInstallMessageHandler(m_handler);
        QDir::setCurrent(m_folder);
        attractor::selectSimd(m_instructions);
        pthread_sigmask(SIG_SETMASK, &m_signals, nullptr);
    }

private:
    sigset_t m_signals{};
    QString m_folder = QDir::currentPath();
    std::string m_instructions = attractor::simdName();
    QtMessageHandler m_handler = nullptr;
};

} // namespace

void compare(double actual, double expected, double tolerance) {
    QVERIFY2(std::abs(actual - expected) <= tolerance,
             qPrintable(QStringLiteral("%1 is not %2").arg(actual, 0, 'g', 17).arg(expected, 0, 'g', 17)));
}

void compare(const QJsonValue& pair, double x, double y, double tolerance) {
    QCOMPARE(pair.toArray().size(), 2);
    compare(pair[0].toDouble(), x, tolerance);
    compare(pair[1].toDouble(), y, tolerance);
}

QJsonObject CommandLineTest::Result::entry(int index) const {
    return QJsonDocument::fromJson(out)[QLatin1String("entries")][index].toObject();
}

void CommandLineTest::initTestCase() {
    QVERIFY(m_folder.isValid());
    write("systems.ifs", "maple {\r\n"
                         " -0.04 0 -0.23 -0.65 -0.08 0.26 .25\r\n"
                         " 0.61 0 0 0.31 0.07 3.5 .25\r\n"
                         " 0.65 0.29 -0.3 0.48 0.74 0.39 .25\r\n"
                         " 0.64 -0.3 0.16 0.56 -0.56 0.60 .25\r\n"
                         "}\r\n"
                         "Fern { ; Barnsley\n"
                         " 0 0 0 0.16 0 0 .01\n"
                         " 0.85 0.04 -0.04 0.85 0 1.6 .85\n"
                         " 0.2 -0.26 0.23 0.22 0 1.6 .07\n"
                         " -0.15 0.28 0.26 0.24 0 0.44 .07\n"
                         "}\n"
                         "spin {\n 0 -1 1 0 0 0 1\n}\n");
    write("broken.ifs", "good {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 1 0 .5\n}\nbad {\n .5 0 0 oops 0 0 1\n}\n");
}

CommandLineTest::Result CommandLineTest::run(const QByteArray& arguments, const QByteArray& input) const {
    std::vector<std::string> words;
    for (const QString& word : QProcess::splitCommand(QString::fromUtf8(arguments)))
        words.push_back(word.toStdString());
    std::fflush(nullptr);
    const ProcessState state(m_folder.path());
    const ReplacedStream in(STDIN_FILENO, input), out(STDOUT_FILENO), err(STDERR_FILENO);
    if (!in.isReplaced() || !out.isReplaced() || !err.isReplaced()) return {};
    const cli::ExitStatus status = cli::run(words);
    std::fflush(nullptr);
    return {int(status), out.bytes(), err.bytes()};
}

CommandLineTest::Result CommandLineTest::runProgram(const QByteArray& arguments,
                                                    const QByteArray& input) const {
    QProcess process;
    start(process, arguments);
    process.write(input);
    process.closeWriteChannel();
    if (!process.waitForFinished(120'000)) return {};
    if (process.exitStatus() != QProcess::NormalExit) return {};
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

void CommandLineTest::start(QProcess& process, const QByteArray& arguments) const {
    process.setWorkingDirectory(m_folder.path());
    process.start(support::buildPath(QStringLiteral("barycage-cli")),
                  QProcess::splitCommand(QString::fromUtf8(arguments)));
}

QString CommandLineTest::path(const QByteArray& name) const {
    return m_folder.filePath(QString::fromUtf8(name));
}

void CommandLineTest::write(const QByteArray& name, const QByteArray& bytes) const {
    QFile file(path(name));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
}

QByteArray CommandLineTest::read(const QByteArray& name) const {
    QFile file(path(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void CommandLineTest::makeOld(const QByteArray& name) const {
    QFile file(path(name));
    QVERIFY(file.open(QIODevice::ReadWrite));
    QVERIFY(file.setFileTime(QDateTime::currentDateTime().addDays(-1), QFileDevice::FileModificationTime));
}
