// SPDX-License-Identifier: MIT
#include "attractor/render/render_queue.h"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#ifdef __linux__
#include <unistd.h>
#endif

namespace attractor {

struct RenderQueue::State {
    struct Waiting {
        std::uint64_t key = 0;
        Job job;
    };

    ~State();
    void serve();
    void draw(const Job& job, const std::stop_token& stop);
    void abandon(std::optional<std::uint64_t> key); // requires the mutex; nullopt: any job

    std::mutex mutex;
    std::condition_variable wake;
    std::deque<Waiting> waiting;
    std::optional<std::uint64_t> present; // key of the job being drawn
    std::stop_source presentStop;
    bool quit = false;
    std::optional<Rendering> rendering;       // used by the thread only; its memory serves every request
    std::jthread thread{[this] { serve(); }}; // last member: uses the others
};

RenderQueue::State::~State() {
    const std::lock_guard lock(mutex);
    quit = true;
    presentStop.request_stop();
    wake.notify_one();
}

void RenderQueue::State::abandon(std::optional<std::uint64_t> key) {
    if (!key || present == key) presentStop.request_stop();
}

void RenderQueue::State::serve() {
#ifdef __linux__
    [[maybe_unused]] const int niceness = ::nice(10); // affects this thread only; failure is harmless
#endif
    while (true) {
        Job job;
        std::stop_token stop;
        {
            std::unique_lock lock(mutex);
            present.reset();
            wake.wait(lock, [this] { return quit || !waiting.empty(); });
            if (quit) return;
            present = waiting.front().key;
            job = std::move(waiting.front().job);
            waiting.pop_front();
            presentStop = {};
            stop = presentStop.get_token();
        }
        draw(job, stop);
    }
}

void RenderQueue::State::draw(const Job& job, const std::stop_token& stop) {
    auto request = job.request();
    std::shared_ptr<const Frame> frame;
    if (request) {
        if (rendering)
            rendering->restart(*std::move(request));
        else
            rendering.emplace(*std::move(request));
        if (!rendering->refine(stop)) return;
        frame = std::make_shared<const Frame>(rendering->frame({}, stop));
    }
    if (!stop.stop_requested()) job.done(std::move(frame));
}

RenderQueue::RenderQueue() : m_state(std::make_unique<State>()) {}

RenderQueue::~RenderQueue() = default;

void RenderQueue::submit(std::uint64_t key, Job job) {
    const std::lock_guard lock(m_state->mutex);
    m_state->abandon(key);
    auto& waiting = m_state->waiting;
    const auto same =
        std::find_if(waiting.begin(), waiting.end(), [key](const auto& other) { return other.key == key; });
    if (same != waiting.end())
        same->job = std::move(job);
    else
        waiting.push_back({key, std::move(job)});
    m_state->wake.notify_one();
}

void RenderQueue::cancel(std::uint64_t key) {
    const std::lock_guard lock(m_state->mutex);
    m_state->abandon(key);
    std::erase_if(m_state->waiting, [key](const auto& other) { return other.key == key; });
}

void RenderQueue::clear() {
    const std::lock_guard lock(m_state->mutex);
    m_state->abandon(std::nullopt);
    m_state->waiting.clear();
}

} // namespace attractor
