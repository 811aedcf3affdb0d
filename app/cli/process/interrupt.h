// SPDX-License-Identifier: MIT
#pragma once

#include "options/exit_status.h"

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <stop_token>
#include <thread>

namespace cli {

// Turns Ctrl+C, a request to terminate and the end of the terminal into a stop request. Make it before any
// other thread. What waits for others, or computes on regardless, is ended a second later, or by a second
// Ctrl+C: files that are not finished have no name yet, and what is said is no more than that. A limit of
// time does the same when it has passed.
class Interrupt {
public:
    using Time = std::chrono::duration<double>;

    explicit Interrupt(std::optional<Time> limit = {});
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;
    ~Interrupt();

    std::stop_token token() const { return m_source.get_token(); }
    bool isOutOfTime() const;
    // Status once the stop is requested: 128 and the number of the signal, as in shells; CannotReadOrWrite
    // when the limit has passed.
    ExitStatus status() const;

private:
    std::shared_ptr<std::atomic<int>> m_signal = std::make_shared<std::atomic<int>>(0);
    std::stop_source m_source;
    std::jthread m_watch;
};

} // namespace cli
