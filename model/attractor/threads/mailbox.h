// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

namespace attractor {

// Hands jobs from any thread to one worker: only the newest is kept, and the job under way is asked to stop.
template <class Job> class Mailbox {
public:
    // Takes the place of a job that waits; nullopt: nothing is to be done.
    void put(std::optional<Job> job) {
        const std::lock_guard lock(m_mutex);
        m_present.request_stop();
        m_waiting = std::move(job);
        m_wake.notify_one();
    }

    void close() { // makes take() return nullopt from now on
        const std::lock_guard lock(m_mutex);
        m_isClosed = true;
        m_present.request_stop();
        m_wake.notify_one();
    }

    struct Delivery {
        Job job;
        std::stop_token stop; // requested when another job arrives or the mailbox closes
    };
    // Waits for a job, in the worker. nullopt when closed.
    std::optional<Delivery> take() {
        std::unique_lock lock(m_mutex);
        m_wake.wait(lock, [this] { return m_isClosed || m_waiting; });
        if (m_isClosed) return std::nullopt;
        Job job = *std::exchange(m_waiting, std::nullopt);
        m_present = {};
        return Delivery{std::move(job), m_present.get_token()};
    }

    // Waits for `time`, in the worker; false as soon as the job under way is to stop.
    bool staysIdle(std::chrono::milliseconds time, const std::stop_token& stop) {
        std::unique_lock lock(m_mutex);
        return !m_wake.wait_for(lock, time, [&] { return m_isClosed || stop.stop_requested(); });
    }

private:
    std::mutex m_mutex;
    std::condition_variable m_wake;
    std::optional<Job> m_waiting;
    std::stop_source m_present; // stop source of the job being worked on
    bool m_isClosed = false;
};

} // namespace attractor
