// SPDX-License-Identifier: MIT
#include "process/files_read.h"

#include "options/tr.h"
#include "options/usage_error.h"
#include "process/same_file.h"

#include <QSet>

#include <algorithm>

namespace cli {

namespace {

QSet<QString>& filesRead() {
    static QSet<QString> paths;
    return paths;
}

} // namespace

void noteRead(const QString& path) {
    filesRead() << fileBehind(path);
}

void forgetFilesRead() {
    filesRead().clear();
}

void refuseToReplaceInput(const QString& output) {
    const auto isIt = [&output](const QString& path) { return isReplacedBy(output, path); };
    if (std::any_of(filesRead().cbegin(), filesRead().cend(), isIt))
        throw UsageError{
            tr("“%1” is an input file, and the output would replace it. Write to another file.").arg(output)};
}

} // namespace cli
