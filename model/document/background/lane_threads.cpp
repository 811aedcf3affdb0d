// SPDX-License-Identifier: MIT
#include "document/background/lane_threads.h"

#include <system_error>
#include <thread>
#include <utility>

namespace document {

LaneThreads::LaneThreads(int most) : m_most(most) {
    std::thread([this] { serve(true); }).detach();
}

void LaneThreads::start(std::function<void()> work) {
    const std::lock_guard lock(m_mutex);
    m_waiting.push_back(std::move(work));
    // Notifies even if none seems idle: threads woken for earlier work may still count as idle.
    if (int(m_waiting.size()) <= m_idle || m_threads >= m_most) return m_wake.notify_one();
    ++m_threads;
    try {
        std::thread([this] { serve(false); }).detach();
    } catch (const std::system_error&) { // no further threads: the existing ones do all the work
        --m_threads;
        m_wake.notify_one();
    }
}

bool LaneThreads::waitForWork(Lock& lock, bool isLasting) {
    constexpr auto longest = std::chrono::seconds(30);
    const auto isThere = [this] { return !m_waiting.empty(); };
    ++m_idle;
    if (isLasting)
        m_wake.wait(lock, isThere);
    else
        m_wake.wait_for(lock, longest, isThere);
    --m_idle;
    return isThere();
}

void LaneThreads::serve(bool isLasting) {
    Lock lock(m_mutex);
    while (waitForWork(lock, isLasting)) {
        std::function<void()> work = std::move(m_waiting.front());
        m_waiting.pop_front();
        ++m_busy;
        lock.unlock();
        work();
        work = nullptr; // releases its captures before it counts as done
        lock.lock();
        --m_busy;
        if (m_busy == 0 && m_waiting.empty()) m_rest.notify_all();
    }
    --m_threads;
}

bool LaneThreads::finish(std::chrono::steady_clock::time_point late) {
    Lock lock(m_mutex);
    return m_rest.wait_until(lock, late, [this] { return m_busy == 0 && m_waiting.empty(); });
}

} // namespace document
