// SPDX-License-Identifier: MIT
#pragma once

#include "io/exports/task_folder.h"

#include <QThreadPool>

#include <functional>

namespace io {

// A folder of tasks whose disk may be slow: another thread reads and writes, in the order of the calls. What
// is handed over is called in that thread.
class TaskStore {
public:
    explicit TaskStore(const QString& folder);
    ~TaskStore(); // when all is written

    void write(const QString& id, const ExportTask& task, std::function<void(bool isKept)> done = {});
    void remove(const QString& id);
    void takeOver(std::function<void(const TaskFolder::TakenOver&)> done);
    void waitForDone() { m_writer.waitForDone(); }

private:
    TaskFolder m_folder;  // used by the thread alone
    QThreadPool m_writer; // of one thread
};

} // namespace io
