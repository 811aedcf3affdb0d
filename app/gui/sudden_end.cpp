// SPDX-License-Identifier: MIT
#include "sudden_end.h"

#include "document/background/background_threads.h"
#include "files/exports.h"
#include "files/recovery.h"
#include "session/session.h"

#include <QDeadlineTimer>
#include <QGuiApplication>
#include <QSocketNotifier>

#include <array>
#include <chrono>

#ifdef Q_OS_UNIX
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <fcntl.h>
#include <unistd.h>
#endif

using namespace std::chrono_literals;

namespace {

void storeUnsaved() {
    for (SessionWindow* window : session::windows())
        window->recovery().store();
}

// Also gives up the locks of stored files, so that the next start need not find out that nobody has them.
void storeAndLetGo() {
    const QDeadlineTimer late(2500ms);
    document::announceEnd();
    storeUnsaved();
    exports::queue()->shutDown();
    session::remember();
    for (SessionWindow* window : session::windows())
        window->recovery().letGo();
    for (const document::Lane lane : {document::Lane::Saving, document::Lane::Exporting})
        document::laneFinishes(lane, std::chrono::milliseconds(late.remainingTime()));
}

} // namespace

SuddenEnd::SuddenEnd() {
    connect(qApp, &QGuiApplication::commitDataRequest, this, [] {
        storeUnsaved();
        session::remember();
    });
    watchSignals();
}

#ifdef Q_OS_UNIX

namespace {

constexpr std::array caught{SIGHUP, SIGINT, SIGTERM};
constexpr unsigned longest = 10; // seconds, even if the GUI thread is busy

std::array<int, 2> pipeEnds{-1, -1}; // a signal handler may do no more than write into the pipe
volatile std::sig_atomic_t first = 0;
volatile std::int64_t firstMoment = 0;

std::int64_t milliseconds() {
    timespec now{};
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    return std::int64_t(now.tv_sec) * 1000 + now.tv_nsec / 1'000'000;
}

void endAsUsual(int signal) {
    std::signal(signal, SIG_DFL);
    ::raise(signal);
}

// The end of a session, or of a terminal, may send several at once: they count as one.
extern "C" void note(int signal) {
    constexpr std::int64_t together = 250;
    if (first != 0) {
        if (milliseconds() - firstMoment > together) endAsUsual(signal);
        return;
    }
    firstMoment = milliseconds();
    first = signal;
    ::alarm(longest);
    const int error = errno;
    [[maybe_unused]] const auto written = ::write(pipeEnds[1], "", 1);
    errno = error;
}

extern "C" void endLate(int) {
    endAsUsual(first);
}

void handle(int signal, void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    ::sigaction(signal, &action, nullptr);
}

// Returns true if the caller wants the signal ignored, as nohup does.
bool isIgnored(int signal) {
    struct sigaction action {};
    return ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

} // namespace

void SuddenEnd::watchSignals() {
    if (::pipe(pipeEnds.data()) != 0) return; // signals keep their default action
    for (const int end : pipeEnds) {
        ::fcntl(end, F_SETFD, FD_CLOEXEC);
        ::fcntl(end, F_SETFL, O_NONBLOCK);
    }
    auto* notifier = new QSocketNotifier(pipeEnds[0], QSocketNotifier::Read, this);
    connect(notifier, &QSocketNotifier::activated, this, &SuddenEnd::endBySignal);
    handle(SIGALRM, endLate);
    for (const int signal : caught)
        if (!isIgnored(signal)) handle(signal, note);
}

void SuddenEnd::endBySignal() {
    storeAndLetGo();
    std::fflush(nullptr);
    endAsUsual(first);
    document::quickExit(128 + first); // fallback if the signal is blocked
}

SuddenEnd::~SuddenEnd() {
    if (pipeEnds[0] < 0) return;
    for (const int signal : caught)
        if (!isIgnored(signal)) handle(signal, SIG_DFL);
    for (const int end : pipeEnds)
        ::close(end);
    pipeEnds = {-1, -1};
}

#else

void SuddenEnd::watchSignals() {}
void SuddenEnd::endBySignal() {}
SuddenEnd::~SuddenEnd() = default;

#endif
