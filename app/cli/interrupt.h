// SPDX-License-Identifier: MIT
#pragma once

#include <stop_token>
#include <thread>

namespace cli {

// Turns Ctrl+C, a request to terminate and the end of the terminal into a stop request. Make it before any
// other thread. What waits for others, or computes on regardless, is ended a second later, or by a second
// Ctrl+C: files that are not finished have no name yet.
class Interrupt {
public:
    Interrupt();

    std::stop_token token() const { return m_source.get_token(); }

private:
    std::stop_source m_source;
    std::jthread m_watch;
};

} // namespace cli
