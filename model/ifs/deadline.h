// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/processor_clock.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

namespace ifs {

// Requests a stop when this process has computed for so much time since it was made; without a time it never
// does.
class Deadline {
public:
    using Time = std::chrono::duration<double>;

    explicit Deadline(std::optional<Time> time) {
        if (!time) return;
        m_watch = std::jthread(
            [this, last = ProcessorClock::now() + *time](const std::stop_token& end) { watch(end, last); });
    }

    std::stop_token token() const { return m_source.get_token(); }
    bool hasPassed() const { return m_source.stop_requested(); }

private:
    void watch(const std::stop_token& end, ProcessorClock::time_point last) {
        constexpr Time tick(0.002);
        std::mutex mutex;
        std::unique_lock lock(mutex);
        std::condition_variable_any waiting;
        Time left = last - ProcessorClock::now();
        for (; left > Time::zero() && !end.stop_requested(); left = last - ProcessorClock::now())
            waiting.wait_for(lock, end, std::max(left, tick), [] { return false; });
        if (!end.stop_requested()) m_source.request_stop();
    }

    std::stop_source m_source;
    std::jthread m_watch;
};

} // namespace ifs
