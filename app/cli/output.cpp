// SPDX-License-Identifier: MIT
#include "output.h"

#include "messages.h"

#include "io/save_file.h"

#include <QCoreApplication>
#include <QFile>
#include <QTemporaryDir>

namespace cli {

namespace {

QString cannotPrint() {
    return QCoreApplication::translate("cli", "It cannot be written to standard output.");
}

} // namespace

bool isStandardOutput(const QString& output) {
    return output == u"-";
}

ExitStatus writeOutput(const QString& output, const QByteArray& bytes) {
    io::Failure failure;
    if (!isStandardOutput(output))
        failure = io::saveFile(output, bytes);
    else if (!print(bytes))
        failure = cannotPrint();
    if (!failure) return ExitStatus::Done;
    reportError(output, *failure);
    return ExitStatus::CannotReadOrWrite;
}

io::ExportOutcome exportOutput(const io::Export& what, const QString& output, const io::Progress& progress,
                               std::stop_token stop) {
    if (!isStandardOutput(output)) return io::exportTo(what, output, progress, std::move(stop));
    QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("output")));
    io::ExportOutcome outcome = io::exportTo(what, file.fileName(), progress, std::move(stop));
    if (outcome.failure || outcome.stopped) return outcome;
    constexpr qint64 pieceSize = 1 << 20;
    bool good = file.open(QIODevice::ReadOnly);
    folder.remove(); // who reads may stop us at any moment; what is open can still be read
    while (good && !file.atEnd())
        good = print(file.read(pieceSize));
    if (!good) outcome.failure = cannotPrint();
    return outcome;
}

} // namespace cli
