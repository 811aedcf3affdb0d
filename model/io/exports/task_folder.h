// SPDX-License-Identifier: MIT
#pragma once

#include "io/exports/export_task.h"

#include <QList>
#include <QString>
#include <QStringList>

#include <map>
#include <memory>

namespace document {
class ProcessLock;
}

namespace io {

// The tasks of a process, one small file each, which its owner alone may read. A file is replaced as a whole,
// and belongs to one process at a time: docs/decisions/0025-exports-wait-in-files.md. One thread at a time.
class TaskFolder {
public:
    explicit TaskFolder(const QString& folder); // creates the folder on demand
    ~TaskFolder();                              // leaves remaining tasks to the next owner

    TaskFolder(const TaskFolder&) = delete;
    TaskFolder& operator=(const TaskFolder&) = delete;

    static QString newId();

    // A task of ours, new or changed; false where it cannot be kept.
    bool write(const QString& id, const ExportTask& task);
    void remove(const QString& id);
    void letGo(); // releases all tasks for the next owner

    // Tasks of processes that are gone, which are ours from now on, in their order; and what is no task, in
    // sentences. Its file gets another name, so that it is said once.
    struct Found {
        QString id;
        ExportTask task;
    };
    struct TakenOver {
        QList<Found> tasks;
        QStringList skipped;
    };
    TakenOver takeOver();

private:
    QString pathOf(const QString& id) const;
    bool own(const QString& id);
    void claim(const QString& path, TakenOver& taken);

    QString m_folder;
    std::map<QString, std::unique_ptr<document::ProcessLock>> m_locks; // locks of our tasks by id
};

} // namespace io
