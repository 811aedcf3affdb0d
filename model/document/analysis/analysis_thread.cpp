// SPDX-License-Identifier: MIT
#include "document/analysis/analysis_thread.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#ifdef __linux__
#include <unistd.h>
#endif

namespace document {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds patience{150}; // time that a queued request waits for the one before it

} // namespace

struct AnalysisThread::State {
    explicit State(std::function<void()> callback)
        : ready(std::move(callback)), thread([this] { serve(); }) {}
    ~State();

    void serve();
    void work(const AnalysisRequest& request, const std::stop_token& stop);
    void publish(Analysis analysis);

    std::function<void()> ready;
    std::mutex mutex;
    std::condition_variable wake;
    std::optional<AnalysisRequest> waiting;
    std::stop_source present; // stop source of the request being worked on
    Clock::time_point begun;
    bool quit = false;
    bool announced = false; // true between the calls of ready and newest()
    std::shared_ptr<const Analysis> newest;
    Analyser analyser;   // used by the worker only
    std::jthread thread; // last member: uses the others
};

AnalysisThread::State::~State() {
    const std::lock_guard lock(mutex);
    quit = true;
    present.request_stop();
    wake.notify_one();
}

void AnalysisThread::State::serve() {
#ifdef __linux__
    [[maybe_unused]] const int niceness = ::nice(10); // affects this thread only; failure is harmless
#endif
    while (true) {
        AnalysisRequest request;
        std::stop_token stop;
        {
            std::unique_lock lock(mutex);
            wake.wait(lock, [this] { return quit || waiting; });
            if (quit) return;
            request = *std::exchange(waiting, std::nullopt);
            present = {};
            begun = Clock::now();
            stop = present.get_token();
        }
        work(request, stop);
    }
}

void AnalysisThread::State::work(const AnalysisRequest& request, const std::stop_token& stop) {
    Analysis quick = analyser.begun(request);
    publish(quick); // even if a newer request waits, so that a drag shows results of slow systems
    if (quick.isComplete || stop.stop_requested()) return;
    if (auto complete = analyser.completed(std::move(quick), stop)) publish(*std::move(complete));
}

void AnalysisThread::State::publish(Analysis analysis) {
    auto shared = std::make_shared<const Analysis>(std::move(analysis));
    {
        const std::lock_guard lock(mutex);
        newest.swap(shared);
        if (std::exchange(announced, true)) return;
    }
    ready();
}

AnalysisThread::AnalysisThread(std::function<void()> ready)
    : m_state(std::make_unique<State>(std::move(ready))) {}

AnalysisThread::~AnalysisThread() = default;

void AnalysisThread::submit(AnalysisRequest request, Haste haste) {
    const std::lock_guard lock(m_state->mutex);
    if (haste == Haste::Now || Clock::now() - m_state->begun > patience) m_state->present.request_stop();
    m_state->waiting = std::move(request);
    m_state->wake.notify_one();
}

void AnalysisThread::cancel() {
    const std::lock_guard lock(m_state->mutex);
    m_state->present.request_stop();
    m_state->waiting.reset();
}

std::shared_ptr<const Analysis> AnalysisThread::newest() {
    const std::lock_guard lock(m_state->mutex);
    m_state->announced = false;
    return m_state->newest;
}

} // namespace document
