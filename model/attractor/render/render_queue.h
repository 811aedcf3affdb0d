// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/render/renderer.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace attractor {

// Pictures that may wait, such as thumbnails: one after the other in the order of submission, on a thread of
// low priority.
class RenderQueue {
public:
    RenderQueue();
    ~RenderQueue(); // drops waiting jobs, abandons the current one, joins

    RenderQueue(const RenderQueue&) = delete;
    RenderQueue& operator=(const RenderQueue&) = delete;

    // A job's functions are called on the queue's thread and may call the queue.
    struct Job {
        std::function<std::optional<RenderRequest>()> request; // nullopt: nothing to draw
        // Receives the frame of one pass, or nullptr when there was nothing to draw; not called when
        // cancelled.
        std::function<void(std::shared_ptr<const Frame>)> done;
    };

    // Thread-safe. A waiting job with the same key is replaced; one that is being drawn under that key is
    // abandoned.
    void submit(std::uint64_t key, Job job);
    void cancel(std::uint64_t key); // for the job, done() is at most about to be called
    void clear();                   // cancels all jobs

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace attractor
