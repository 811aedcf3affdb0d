// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <stop_token>
#include <thread>

namespace support {

// Asks work to stop in the middle: so long after this is made. It is a fixed time because nothing tells from
// outside how far the work has come.
class LateStop {
public:
    using Clock = std::chrono::steady_clock;

    explicit LateStop(Clock::duration late)
        : m_thread([this, late] {
              std::this_thread::sleep_for(late); // the work goes on meanwhile
              m_asked = Clock::now();
              m_source.request_stop();
          }) {}

    std::stop_token token() const { return m_source.get_token(); }
    // When it was asked; waits until then.
    Clock::time_point asked() {
        if (m_thread.joinable()) m_thread.join();
        return m_asked;
    }

private:
    std::stop_source m_source;
    Clock::time_point m_asked;
    std::jthread m_thread; // last: it uses the rest
};

} // namespace support
