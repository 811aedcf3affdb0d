// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>
#include <QByteArrayList>
#include <QMap>
#include <QString>
#include <QStringList>

#include <functional>
#include <optional>
#include <vector>

namespace support {

/// How a program ended.
struct Ended {
    int status = -1; ///< of a program that crashed or took too long
    QByteArray out;
    QByteArray err;
};

enum class Lasting { No, Yes }; ///< whether what fails goes on failing from then on

/// A program one of whose system calls, or of whose requests for memory, fails.
class FaultyProgram {
public:
    /// Calls are counted from the first one that names something that begins with `mark`; requests for memory
    /// from the start, or with the mark of the program `writing` from its begin() on.
    FaultyProgram(QStringList command, QString mark)
        : m_command(std::move(command)), m_mark(std::move(mark)) {}

    /// What the program calls when nothing fails, in order; nullopt where the kernel cannot make calls fail.
    std::optional<QByteArrayList> calls(Ended& ended) const;
    Ended withFailingCall(int which, Lasting lasting) const; ///< counted from 1

    /// How often the program asks for memory when there is enough.
    long allocations() const;
    Ended withFailingAllocation(long which, Lasting lasting) const; ///< counted from 1

private:
    QStringList m_command;
    QString m_mark;
};

/// The numbers of at most `most` calls, counted from 1: different ones before the same ones again, others for
/// another `turn`.
std::vector<int> sampleOf(const QByteArrayList& calls, int most, int turn);
/// The numbers of at most `most` of `count` allocations, evenly spaced, others for another `turn`.
std::vector<long> sampleOf(long count, long most, int turn);

/// The mark of the program `writing`.
inline QString markOfWriting() {
    return QStringLiteral("/barycage/begin");
}

/// All files of a folder, by name.
QMap<QString, QByteArray> contentsOf(const QString& folder);

} // namespace support
