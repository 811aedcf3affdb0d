// SPDX-License-Identifier: MIT
#include "interrupt.h"

#include "exit_status.h"
#include "messages.h"

#include <QCoreApplication>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <system_error>

namespace cli {

namespace {

using Clock = std::chrono::steady_clock;
constexpr auto patience = std::chrono::seconds(1);

// Those that the caller does not want ignored, as nohup does.
sigset_t watched() {
    sigset_t set;
    sigemptyset(&set);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction action {};
        if (sigaction(number, nullptr, &action) == 0 && action.sa_handler != SIG_IGN) sigaddset(&set, number);
    }
    return set;
}

void watch(const std::stop_token& end, const sigset_t& set, std::stop_source source) {
    constexpr timespec tick{0, 50'000'000};
    Clock::time_point latest = Clock::time_point::max();
    while (!end.stop_requested()) {
        const bool isSignalled = sigtimedwait(&set, nullptr, &tick) >= 0;
        if (Clock::now() > latest || (isSignalled && source.stop_requested())) {
            reportError(QStringLiteral("barycage-cli"), QCoreApplication::translate("cli", "Interrupted."));
            std::_Exit(int(ExitStatus::Interrupted));
        }
        if (!isSignalled) continue;
        source.request_stop();
        latest = Clock::now() + patience;
    }
}

} // namespace

Interrupt::Interrupt() {
    const sigset_t set = watched();
    pthread_sigmask(SIG_BLOCK, &set, nullptr); // threads made from here on inherit it
    try {
        m_watch = std::jthread(watch, set, m_source);
    } catch (const std::system_error&) { // no thread to be had: a signal ends the program
        pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
    }
}

} // namespace cli
