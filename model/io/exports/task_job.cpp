// SPDX-License-Identifier: MIT
#include "io/exports/task_job.h"

#include "document/text/text.h"
#include "io/fractint/fractint_reader.h"

#include <QDir>
#include <QFileInfo>

#include <condition_variable>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <utility>

#ifdef Q_OS_LINUX
#include <sys/resource.h>
#endif

namespace io {

namespace {

// The canvas goes first. Threads made by this one inherit it.
void yieldToOthers() {
#ifdef Q_OS_LINUX
    constexpr int nice = 10;
    ::setpriority(PRIO_PROCESS, 0, nice); // affects this thread only
#endif
}

// Runs in a thread of its own: that of the lane goes on to other work, and cannot stop yielding.
void yielding(const std::function<void()>& work) {
    try {
        std::thread([&] {
            yieldToOthers();
            work();
        }).join();
    } catch (const std::system_error&) { // no thread available
        work();
    }
}

TaskJob::Outcome draw(const ExportTask& task, const Progress& progress, const std::stop_token& stop) {
    if (!task.mayReplace && QFileInfo::exists(task.path))
        return {
            Text::tr("A file “%1” was created after you added this export. Choose Try Again to replace it.")
                .arg(QDir::toNativeSeparators(task.path)),
            false, true};
    const document::FractalFile file = readFractint(task.entry);
    const int wanted = isInSpace(task.recipe) ? 3 : 2;
    if (file.entries.isEmpty() || document::dimension(*file.entries.first().fractal) != wanted)
        return {Text::tr("The fractal in this export cannot be read."), false, false};
    const ExportOutcome outcome =
        exportTo(exportOf(task.recipe, *file.entries.first().fractal), task.path, progress, stop);
    return {outcome.failure, outcome.stopped, false};
}

TaskJob::Outcome drawn(const ExportTask& task, const Progress& progress, const std::stop_token& stop) {
    try {
        return draw(task, progress, stop);
    } catch (const std::bad_alloc&) {
        return {Text::tr("There is not enough memory for this picture."), false, false};
    }
}

} // namespace

struct TaskJob::Gate {
    std::mutex mutex;
    std::condition_variable_any opened;
    bool isShut = false;

    void pass(const std::stop_token& stop) {
        std::unique_lock lock(mutex);
        opened.wait(lock, stop, [this] { return !isShut; });
    }
};

TaskJob::TaskJob(const ExportTask& task, Progress progress, std::function<void(const Outcome&)> finished)
    : m_gate(std::make_shared<Gate>()),
      m_work([task, gate = m_gate, progress = std::move(progress),
              finished = std::move(finished)](const std::stop_token& stop, document::Listener& listener) {
          const Progress told = [&](double fraction) {
              listener.tell([&] { progress(fraction); });
              gate->pass(stop);
          };
          yielding([&] {
              const Outcome outcome = drawn(task, told, stop);
              listener.tell([&] { finished(outcome); });
          });
      }) {}

void TaskJob::setPaused(bool paused) {
    {
        const std::lock_guard lock(m_gate->mutex);
        m_gate->isShut = paused;
    }
    m_gate->opened.notify_all();
}

} // namespace io
