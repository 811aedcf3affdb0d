// SPDX-License-Identifier: MIT
#pragma once

#include "io/exports/export_task.h"

#include <functional>
#include <memory>
#include <thread>

namespace io {

// Draws a task in the background, in a thread that yields to all others where the system can do that.
// Destroying it stops and waits: milliseconds.
class TaskJob {
public:
    struct Outcome {
        Failure failure;      // why nothing was written
        bool stopped = false; // on request; nothing was written
        bool isTaken = false; // a failure: there is a file now that nobody was asked about
    };
    // `progress` (0 … 1) and `finished` are called in that thread; `finished` exactly once.
    TaskJob(const ExportTask& task, Progress progress, std::function<void(const Outcome&)> finished);
    ~TaskJob();

    void stop() { m_thread.request_stop(); }
    void setPaused(bool paused); // as soon as it has got on a little

private:
    struct Gate;
    std::shared_ptr<Gate> m_gate;
    std::jthread m_thread;
};

} // namespace io
