// SPDX-License-Identifier: MIT
#include "io/exports/task_store.h"

#include <utility>

namespace io {

TaskStore::TaskStore(const QString& folder)
    : m_folder(std::make_shared<TaskFolder>(folder)), m_writer(document::Lane::Saving) {}

TaskStore::~TaskStore() {
    constexpr std::chrono::seconds patience(3);
    letGo();
    finishes(patience);
    m_listener->leave();
}

void TaskStore::write(const QString& id, const ExportTask& task, std::function<void(bool isKept)> done) {
    m_writer.start([folder = m_folder, listener = m_listener, id, task, done = std::move(done)] {
        const bool isKept = folder->write(id, task);
        if (done) listener->tell([&] { done(isKept); });
    });
}

void TaskStore::remove(const QString& id) {
    m_writer.start([folder = m_folder, id] { folder->remove(id); });
}

void TaskStore::takeOver(std::function<void(const TaskFolder::TakenOver&)> done) {
    m_writer.start([folder = m_folder, listener = m_listener, done = std::move(done)] {
        const TaskFolder::TakenOver taken = folder->takeOver();
        listener->tell([&] { done(taken); });
    });
}

void TaskStore::letGo() {
    m_writer.start([folder = m_folder] { folder->letGo(); });
}

} // namespace io
