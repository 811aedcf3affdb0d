// SPDX-License-Identifier: MIT
#include "process/files_read.h"

#include "options/tr.h"
#include "options/usage_error.h"
#include "process/same_file.h"

#include <QFileInfo>
#include <QHash>
#include <QSet>

#include <algorithm>

namespace cli {

namespace {

QSet<QString>& filesRead() {
    static QSet<QString> paths;
    return paths;
}

// The files that were written, without links, and under which name.
QHash<QString, QString>& filesWritten() {
    static QHash<QString, QString> names;
    return names;
}

} // namespace

void noteRead(const QString& path) {
    filesRead() << fileBehind(path);
}

void forgetFilesRead() {
    filesRead().clear();
    filesWritten().clear();
}

void refuseToReplaceInput(const QString& output) {
    const auto isIt = [&output](const QString& path) { return isReplacedBy(output, path); };
    if (std::any_of(filesRead().cbegin(), filesRead().cend(), isIt))
        throw UsageError{
            tr("“%1” is an input file, and the output would replace it. Write to another file.").arg(output)};
}

void noteWritten(const QString& output) {
    if (!isStandardOutput(output)) filesWritten().insert(QFileInfo(output).canonicalFilePath(), output);
}

void refuseToReplaceOutput(const QString& output) {
    if (isStandardOutput(output)) return;
    const QString before = filesWritten().value(QFileInfo(output).canonicalFilePath(), output);
    if (before != output)
        throw UsageError{tr("“%1” leads to “%2”, which has just been written. Write to another file.")
                             .arg(output, before)};
}

} // namespace cli
