// SPDX-License-Identifier: MIT
#pragma once

#include <stop_token>
#include <thread>

namespace cli {

// Turns Ctrl+C (and a request to terminate) into a stop request. Make it before any other thread. A second
// Ctrl+C ends the program at once.
class Interrupt {
public:
    Interrupt();

    std::stop_token token() const { return m_source.get_token(); }

private:
    std::stop_source m_source;
    std::jthread m_watch;
};

} // namespace cli
