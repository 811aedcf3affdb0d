// SPDX-License-Identifier: MIT
#include "process/interrupt.h"

#include "io/file/replacement_file.h"
#include "options/exit_status.h"
#include "options/tr.h"
#include "process/messages.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <system_error>

namespace cli {

namespace {

using Clock = std::chrono::steady_clock;
constexpr Clock::duration patience = std::chrono::seconds(1), lastMoment = std::chrono::milliseconds(250);
constexpr int outOfTime = -1; // in place of a signal
constexpr int wake = SIGURG;  // tells the watch to check whether the work has ended; ignored by default

// Signals that the caller does not want ignored, as nohup does.
sigset_t watched() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, wake);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction action {};
        if (sigaction(number, nullptr, &action) == 0 && action.sa_handler != SIG_IGN) sigaddset(&set, number);
    }
    return set;
}

ExitStatus statusOf(int signal) {
    return signal == outOfTime ? ExitStatus::CannotReadOrWrite : ExitStatus(128 + signal);
}

[[noreturn]] void endNow(int signal) {
    reportError(QStringLiteral("barycage-cli"),
                signal == outOfTime ? tr("The time limit has passed.") : tr("Interrupted."));
    io::removeUnfinished();
    std::_Exit(int(statusOf(signal)));
}

void watch(const std::stop_token& end, const sigset_t& set, std::stop_source source,
           const std::shared_ptr<std::atomic<int>>& first, Clock::time_point limit) {
    constexpr timespec tick{0, 50'000'000};
    Clock::time_point latest = Clock::time_point::max();
    while (!end.stop_requested()) {
        const int signal = sigtimedwait(&set, nullptr, &tick);
        if (signal == wake) continue;
        const bool isSignalled = signal >= 0;
        if (int none = 0; isSignalled) first->compare_exchange_strong(none, signal);
        if (Clock::now() > latest || (isSignalled && source.stop_requested())) endNow(*first);
        const bool isLate = Clock::now() > limit && !source.stop_requested();
        if (int none = 0; isLate) first->compare_exchange_strong(none, outOfTime);
        if (!isSignalled && !isLate) continue;
        source.request_stop();
        latest = Clock::now() + (isSignalled ? patience : lastMoment);
    }
}

} // namespace

Interrupt::Interrupt(std::optional<Time> limit) {
    const auto end =
        limit ? Clock::now() + std::chrono::duration_cast<Clock::duration>(*limit) : Clock::time_point::max();
    const sigset_t set = watched();
    pthread_sigmask(SIG_BLOCK, &set, nullptr); // also for threads started later, which inherit the mask
    try {
        m_watch = std::jthread(watch, set, m_source, m_signal, end);
    } catch (const std::system_error&) { // no thread available: signals then end the program
        pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
    }
}

Interrupt::~Interrupt() {
    m_watch.request_stop();
    if (m_watch.joinable()) pthread_kill(m_watch.native_handle(), wake);
}

bool Interrupt::isOutOfTime() const {
    return *m_signal == outOfTime;
}

ExitStatus Interrupt::status() const {
    return statusOf(*m_signal);
}

} // namespace cli
