// SPDX-License-Identifier: MIT
#pragma once

#include "io/exports/export_recipe.h"
#include "io/file/save_file.h"

#include <QByteArray>
#include <QString>

#include <optional>

namespace io {

// An export that waits for its turn, with all it needs: later edits do not change it.
struct ExportTask {
    QString path;     // absolute path of the file to write
    QString name;     // name of the entry for messages
    QByteArray entry; // text of the entry from writeEntry()
    ExportRecipe recipe;
    bool mayReplace = false; // true if the user agreed to replace the file at `path`
    qint64 place = 0;        // position in the queue, smallest first
    int begun = 0;           // number of attempts by processes that ended before the export did
    QString failure;         // reason of failure, as a sentence; empty: waiting

    friend bool operator==(const ExportTask&, const ExportTask&) = default;
};

// Conversion to and from the file of a task: a line that identifies it, one of JSON, the entry's text.
QByteArray taskFile(const ExportTask& task);
struct ReadTask {
    std::optional<ExportTask> task;
    Failure failure; // reason of failure, as a sentence without the file's name
};
// Never fails in another way, whatever the bytes; every value of the task is in its range.
ReadTask taskIn(const QByteArray& bytes);

} // namespace io
