// SPDX-License-Identifier: MIT
#include "attractor/render_queue.h"

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
    using Done = std::function<void(std::uint64_t, std::shared_ptr<const Frame>)>;
    struct Job {
        std::uint64_t key = 0;
        RenderRequest request;
    };

    explicit State(Done callback) : done(std::move(callback)), thread([this] { serve(); }) {}
    ~State();
    void serve();
    void draw(Job job, const std::stop_token& stop);
    void abandon(std::optional<std::uint64_t> key); // with the mutex held; nullopt: whatever is being drawn

    Done done;
    std::mutex mutex;
    std::condition_variable wake;
    std::deque<Job> waiting;
    std::optional<std::uint64_t> present; // key of what is being drawn
    std::stop_source presentStop;
    bool quit = false;
    std::optional<Rendering> rendering; // the thread's own; its memory serves every request
    std::jthread thread;                // last: it uses the rest
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
    [[maybe_unused]] const int niceness =
        ::nice(10); // of this thread alone; where refused, it works all the same
#endif
    while (true) {
        Job job;
        std::stop_token stop;
        {
            std::unique_lock lock(mutex);
            present.reset();
            wake.wait(lock, [this] { return quit || !waiting.empty(); });
            if (quit) return;
            job = std::move(waiting.front());
            waiting.pop_front();
            present = job.key;
            presentStop = {};
            stop = presentStop.get_token();
        }
        draw(std::move(job), stop);
    }
}

void RenderQueue::State::draw(Job job, const std::stop_token& stop) {
    const std::uint64_t key = job.key;
    if (rendering)
        rendering->restart(std::move(job.request));
    else
        rendering.emplace(std::move(job.request));
    if (!rendering->refine(stop)) return;
    auto frame = std::make_shared<const Frame>(rendering->frame({}, stop));
    if (!stop.stop_requested()) done(key, std::move(frame));
}

RenderQueue::RenderQueue(std::function<void(std::uint64_t key, std::shared_ptr<const Frame>)> done)
    : m_state(std::make_unique<State>(std::move(done))) {}

RenderQueue::~RenderQueue() = default;

void RenderQueue::submit(std::uint64_t key, RenderRequest request) {
    const std::lock_guard lock(m_state->mutex);
    m_state->abandon(key);
    auto& waiting = m_state->waiting;
    const auto same =
        std::find_if(waiting.begin(), waiting.end(), [key](const auto& job) { return job.key == key; });
    if (same != waiting.end())
        same->request = std::move(request);
    else
        waiting.push_back({key, std::move(request)});
    m_state->wake.notify_one();
}

void RenderQueue::cancel(std::uint64_t key) {
    const std::lock_guard lock(m_state->mutex);
    m_state->abandon(key);
    std::erase_if(m_state->waiting, [key](const auto& job) { return job.key == key; });
}

void RenderQueue::clear() {
    const std::lock_guard lock(m_state->mutex);
    m_state->abandon(std::nullopt);
    m_state->waiting.clear();
}

} // namespace attractor
