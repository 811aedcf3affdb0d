// SPDX-License-Identifier: MIT
#pragma once

#include "io/exports/export_task.h"
#include "io/file/export_work.h"

#include <functional>
#include <memory>

namespace io {

// Draws a task in the background, in a thread that yields to all others where the system can do that.
// Destroying it stops it: milliseconds, or at most a second when its drive does not answer.
class TaskJob {
public:
    struct Outcome {
        Failure failure;      // reason why nothing was written
        bool stopped = false; // true if stopped on request; nothing was written
        bool isTaken = false; // true if the file exists by now and nobody agreed to replace it
    };
    // `progress` (0 … 1) and `finished` are called in that thread, not after the end of this; `finished`
    // exactly once.
    TaskJob(const ExportTask& task, Progress progress, std::function<void(const Outcome&)> finished);

    void stop() { m_work.stop(); }
    void setPaused(bool paused); // takes effect after a little more progress

private:
    struct Gate;
    std::shared_ptr<Gate> m_gate;
    ExportWork m_work;
};

} // namespace io
