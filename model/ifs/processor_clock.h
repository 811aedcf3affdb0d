// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <ctime>

namespace ifs {

// The time for which this process has computed, in all of its threads: a busy machine, which stretches all
// other times, does not stretch it. It stands still while the process waits.
struct ProcessorClock {
    using duration = std::chrono::duration<double>;
    using rep = duration::rep;
    using period = duration::period;
    using time_point = std::chrono::time_point<ProcessorClock, duration>;
    static constexpr bool is_steady = false;

    static time_point now() { return time_point(duration(double(std::clock()) / CLOCKS_PER_SEC)); }
};

} // namespace ifs
