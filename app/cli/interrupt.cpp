// SPDX-License-Identifier: MIT
#include "interrupt.h"

#include "exit_status.h"

#include <csignal>
#include <cstdlib>
#include <ctime>

namespace cli {

namespace {

sigset_t watched() {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
    return signals;
}

void watch(const std::stop_token& end, std::stop_source source) {
    constexpr timespec tick{0, 50'000'000};
    const sigset_t signals = watched();
    while (!end.stop_requested()) {
        if (sigtimedwait(&signals, nullptr, &tick) < 0) continue;
        if (source.stop_requested()) std::_Exit(int(ExitStatus::Interrupted));
        source.request_stop();
    }
}

} // namespace

Interrupt::Interrupt() {
    const sigset_t signals = watched();
    pthread_sigmask(SIG_BLOCK, &signals, nullptr); // threads made from here on inherit it
    m_watch = std::jthread(watch, m_source);
}

} // namespace cli
