// SPDX-License-Identifier: MIT
#include "document/background/work_in_order.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <utility>

namespace document {

struct WorkInOrder::Queue {
    explicit Queue(Lane of) : lane(of) {}

    void work();
    std::function<void()> next(); // null: all done

    const Lane lane;
    std::mutex mutex;
    std::condition_variable done;
    std::deque<std::function<void()>> waiting;
    bool isWorking = false;
};

std::function<void()> WorkInOrder::Queue::next() {
    const std::scoped_lock lock(mutex);
    if (waiting.empty()) {
        isWorking = false;
        done.notify_all();
        return {};
    }
    std::function<void()> piece = std::move(waiting.front());
    waiting.pop_front();
    return piece;
}

void WorkInOrder::Queue::work() {
    while (const std::function<void()> piece = next())
        piece();
}

WorkInOrder::WorkInOrder(Lane lane) : m_queue(std::make_shared<Queue>(lane)) {}

void WorkInOrder::start(std::function<void()> piece) {
    const std::scoped_lock lock(m_queue->mutex);
    m_queue->waiting.push_back(std::move(piece));
    if (!std::exchange(m_queue->isWorking, true))
        startInLane(m_queue->lane, [queue = m_queue] { queue->work(); });
}

bool WorkInOrder::finishes(std::chrono::milliseconds patience) const {
    std::unique_lock lock(m_queue->mutex);
    return m_queue->done.wait_for(lock, patience, [this] { return !m_queue->isWorking; });
}

} // namespace document
