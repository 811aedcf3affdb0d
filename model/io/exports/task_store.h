// SPDX-License-Identifier: MIT
#pragma once

#include "document/background/listener.h"
#include "document/background/work_in_order.h"
#include "io/exports/task_folder.h"

#include <chrono>
#include <functional>
#include <memory>

namespace io {

// A folder of tasks whose disk may be slow: another thread reads and writes, in the order of the calls. What
// is handed over is called in that thread, not after the end of this.
class TaskStore {
public:
    explicit TaskStore(const QString& folder);
    ~TaskStore(); // lets pending writes finish later, if the disk answers

    void write(const QString& id, const ExportTask& task, std::function<void(bool isKept)> done = {});
    void remove(const QString& id);
    void takeOver(std::function<void(const TaskFolder::TakenOver&)> done);
    // The program ends: once all is written, the tasks belong to whoever comes next.
    void letGo();
    bool finishes(std::chrono::milliseconds patience) const { return m_writer.finishes(patience); }

private:
    std::shared_ptr<TaskFolder> m_folder; // accessed only by the writing thread
    std::shared_ptr<document::Listener> m_listener = std::make_shared<document::Listener>();
    document::WorkInOrder m_writer;
};

} // namespace io
