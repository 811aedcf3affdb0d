// SPDX-License-Identifier: MIT
#include "support/faults.h"

#include "support/paths.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QProcessEnvironment>
#include <QTemporaryDir>

#include <algorithm>

namespace support {

namespace {

QProcessEnvironment environment() {
    QProcessEnvironment variables = QProcessEnvironment::systemEnvironment();
    variables.insert(QStringLiteral("SOURCE_DATE_EPOCH"), QStringLiteral("1700000000"));
    return variables;
}

Ended run(const QStringList& command, const QProcessEnvironment& variables) {
    QProcess process;
    process.setProcessEnvironment(variables);
    process.start(command.first(), command.sliced(1));
    if (!process.waitForFinished(120'000) || process.exitStatus() != QProcess::NormalExit)
        return {-1, process.readAllStandardOutput(), process.readAllStandardError()};
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

QString numberOf(long which, Lasting lasting) {
    return QString::number(which) + (lasting == Lasting::Yes ? QStringLiteral("+") : QString());
}

Ended runWithFailingCall(const QStringList& command, const QString& mark, const QString& which,
                         const QString& report) {
    constexpr int tooLong = 124, firstSignal = 128;
    const QString program = buildPath(QStringLiteral("tests/support/failing_calls"));
    Ended ended = run(QStringList{program, report, which, mark} + command, environment());
    if (ended.status == tooLong || ended.status >= firstSignal) ended.status = -1;
    return ended;
}

QByteArray bytesOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

Ended runWithAllocations(const QStringList& command, const QString& mark, const QString& which,
                         const QString& counted) {
    const QString failing = mark == markOfWriting() ? u'@' + which : which;
    QProcessEnvironment variables = environment();
    variables.insert(QStringLiteral("LD_PRELOAD"),
                     buildPath(QStringLiteral("tests/support/libfailing_allocations.so")));
    variables.insert(QStringLiteral("BARYCAGE_FAILING"), failing);
    variables.insert(QStringLiteral("BARYCAGE_ALLOCATIONS"), counted);
    return run(command, variables);
}

} // namespace

std::optional<QByteArrayList> FaultyProgram::calls(Ended& ended) const {
    constexpr int cannot = 125;
    const QTemporaryDir folder;
    const QString report = folder.filePath(QStringLiteral("calls"));
    ended = runWithFailingCall(m_command, m_mark, QStringLiteral("0"), report);
    if (ended.status == cannot) return std::nullopt;
    QByteArrayList names = bytesOf(report).split('\n');
    names.removeAll(QByteArray());
    return names;
}

Ended FaultyProgram::withFailingCall(int which, Lasting lasting) const {
    return runWithFailingCall(m_command, m_mark, numberOf(which, lasting), QStringLiteral("/dev/null"));
}

long FaultyProgram::allocations() const {
    const QTemporaryDir folder;
    const QString counted = folder.filePath(QStringLiteral("allocations"));
    runWithAllocations(m_command, m_mark, QStringLiteral("0"), counted);
    return bytesOf(counted).trimmed().toLong();
}

Ended FaultyProgram::withFailingAllocation(long which, Lasting lasting) const {
    return runWithAllocations(m_command, m_mark, numberOf(which, lasting), QStringLiteral("/dev/null"));
}

std::vector<int> sampleOf(const QByteArrayList& calls, int most, int turn) {
    QMap<QByteArray, std::vector<int>> byName;
    for (int i = 0; i < calls.size(); ++i)
        byName[calls[i]].push_back(i + 1);
    std::vector<int> sample;
    const auto kinds = int(byName.size());
    for (int round = 0; int(sample.size()) < std::min(most, int(calls.size())); ++round)
        for (int kind = 0; kind < kinds && int(sample.size()) < most; ++kind) {
            const std::vector<int>& same = std::next(byName.begin(), (kind + turn) % kinds).value();
            const auto at = std::size_t(round + turn);
            if (round < int(same.size())) sample.push_back(same[at % same.size()]);
        }
    std::ranges::sort(sample);
    return sample;
}

std::vector<long> sampleOf(long count, long most, int turn) {
    std::vector<long> sample;
    const long tried = std::min(count, most);
    for (long i = 0; i < tried; ++i)
        sample.push_back(1 + (i * count / tried + turn * 101L) % count);
    return sample;
}

QMap<QString, QByteArray> contentsOf(const QString& folder) {
    QMap<QString, QByteArray> contents;
    const QDir dir(folder);
    for (const QString& name : dir.entryList(QDir::Files | QDir::Hidden | QDir::System))
        contents[name] = bytesOf(dir.filePath(name));
    return contents;
}

} // namespace support
