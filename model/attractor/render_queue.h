// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/renderer.h"

#include <cstdint>
#include <functional>
#include <memory>

namespace attractor {

// Pictures that may wait, such as thumbnails: one after the other in the order of submission, on a thread of
// low priority.
class RenderQueue {
public:
    // `done` is called on the queue's thread, once for every request that was not cancelled, with its frame
    // of one pass. It may call the queue.
    explicit RenderQueue(std::function<void(std::uint64_t key, std::shared_ptr<const Frame>)> done);
    ~RenderQueue(); // forgets what waits, abandons what is being drawn, joins

    RenderQueue(const RenderQueue&) = delete;
    RenderQueue& operator=(const RenderQueue&) = delete;

    // Any thread. A request under a key that is already waiting takes its place; one that is being drawn
    // under the same key is abandoned.
    void submit(std::uint64_t key, RenderRequest request);
    void cancel(std::uint64_t key); // done() may at most be just beginning for it
    void clear();                   // the same for all

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace attractor
