// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>

namespace document {

// Threads that do work in the order in which it comes. There is one from the beginning, so that work is done
// sooner or later also where the system refuses to start another; QThreadPool would wait for such a thread
// without end. The others end when they have had nothing to do for a while.
// Never destroyed: what hangs must not hold up the end of the program.
class LaneThreads {
public:
    // Throws std::system_error when the system starts no thread.
    explicit LaneThreads(int most);
    ~LaneThreads() = delete;
    LaneThreads(const LaneThreads&) = delete;
    LaneThreads& operator=(const LaneThreads&) = delete;

    void start(std::function<void()> work);

    // Waits until nothing is under way or waiting, but no longer than that; whether it is so.
    bool finish(std::chrono::steady_clock::time_point late);

private:
    using Lock = std::unique_lock<std::mutex>;

    void serve(bool isLasting);
    bool waitForWork(Lock& lock, bool isLasting); // false if nothing came for a while

    const int m_most;
    std::mutex m_mutex; // guards all members below
    std::condition_variable m_wake, m_rest;
    std::deque<std::function<void()>> m_waiting;
    int m_threads = 1;
    int m_idle = 0; // threads waiting for work
    int m_busy = 0; // pieces of work under way
};

} // namespace document
