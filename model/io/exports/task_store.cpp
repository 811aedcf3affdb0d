// SPDX-License-Identifier: MIT
#include "io/exports/task_store.h"

#include <utility>

namespace io {

TaskStore::TaskStore(const QString& folder) : m_folder(folder) {
    m_writer.setMaxThreadCount(1);
}

TaskStore::~TaskStore() {
    m_writer.waitForDone();
}

void TaskStore::write(const QString& id, const ExportTask& task, std::function<void(bool isKept)> done) {
    m_writer.start([this, id, task, done = std::move(done)] {
        const bool isKept = m_folder.write(id, task);
        if (done) done(isKept);
    });
}

void TaskStore::remove(const QString& id) {
    m_writer.start([this, id] { m_folder.remove(id); });
}

void TaskStore::takeOver(std::function<void(const TaskFolder::TakenOver&)> done) {
    m_writer.start([this, done = std::move(done)] { done(m_folder.takeOver()); });
}

} // namespace io
