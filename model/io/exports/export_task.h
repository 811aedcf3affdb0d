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
    QString path;     // of the file to write, absolute
    QString name;     // of the entry, for the user
    QByteArray entry; // its text, as writeEntry() gives it
    ExportRecipe recipe;
    bool mayReplace = false; // the file at `path` now; the user was asked
    qint64 place = 0;        // among the others, the smallest first
    int begun = 0;           // how often it was begun by a process that ended before it did
    QString failure;         // why it was not written, in a sentence; empty: it waits

    friend bool operator==(const ExportTask&, const ExportTask&) = default;
};

// Conversion to and from the file of a task: a line that identifies it, one of JSON, the entry's text.
QByteArray taskFile(const ExportTask& task);
struct ReadTask {
    std::optional<ExportTask> task;
    Failure failure; // why there is none, in a sentence without the file's name
};
// Never fails in another way, whatever the bytes; every value of the task is in its range.
ReadTask taskIn(const QByteArray& bytes);

} // namespace io
