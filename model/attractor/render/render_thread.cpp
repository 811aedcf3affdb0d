// SPDX-License-Identifier: MIT
#include "attractor/render/render_thread.h"

#include "attractor/threads/mailbox.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>
#include <optional>
#include <thread>

namespace attractor {

namespace {
// A pass is at most this long, so that a refining picture is seen to refine.
constexpr std::uint64_t maxPass = 100'000'000;
constexpr auto pauseBeforeRefining = std::chrono::milliseconds(50);
constexpr auto timeOfAFrame = std::chrono::milliseconds(16);
constexpr double secondsToAdapt = 0.12; // time constant with which brightness eases
constexpr double unseen = 0.002;        // relative change of brightness that is not noticed

// Frames that nobody shows any more, kept because fresh memory costs as much time as drawing into it.
class FramePool : public std::enable_shared_from_this<FramePool> {
public:
    Frame take() {
        const std::lock_guard lock(m_mutex);
        if (m_spare.empty()) return {};
        Frame frame = std::move(m_spare.back());
        m_spare.pop_back();
        return frame;
    }
    // Returns to the pool with the end of its last owner.
    std::shared_ptr<const Frame> shared(Frame frame) {
        return {new Frame(std::move(frame)), [pool = shared_from_this()](Frame* used) {
                    const std::unique_ptr<Frame> owner(used);
                    pool->giveBack(std::move(*owner));
                }};
    }

private:
    void giveBack(Frame frame) {
        const std::lock_guard lock(m_mutex);
        if (m_spare.size() < 2) m_spare.push_back(std::move(frame));
    }

    std::mutex m_mutex;
    std::vector<Frame> m_spare;
};

// Exposures from frame to frame. Density is measured in the plane, not in pixels: that of an even measure
// does not change with zoom.
class Adaptation {
public:
    void begin(RenderThread::Brightness brightness) {
        m_first = true;
        using Brightness = RenderThread::Brightness;
        m_settled = !m_shown || brightness == Brightness::OfThePicture ||
                    (brightness == Brightness::Continued && m_settled);
    }
    bool settled() const { return m_settled; }

    Exposure next(const Exposure& wanted, double pixelsPerUnit) {
        const auto now = Clock::now();
        if (!m_settled) {
            const std::chrono::duration<double> since =
                m_first ? std::min<Clock::duration>(now - m_time, timeOfAFrame) : now - m_time;
            const double kept = std::exp(-since.count() / secondsToAdapt);
            const double zoom = pixelsPerUnit / m_pixelsPerUnit;
            m_shown->meanDensity /= zoom * zoom;
            m_settled = true;
            for (double Exposure::*value : {&Exposure::meanDensity, &Exposure::whitePoint, &Exposure::gain})
                approach((*m_shown).*value, wanted.*value, kept);
        }
        if (m_settled) m_shown = wanted;
        m_pixelsPerUnit = pixelsPerUnit;
        m_time = now;
        m_first = false;
        return *m_shown;
    }

private:
    using Clock = std::chrono::steady_clock;

    // Geometric, because perceived brightness is logarithmic.
    void approach(double& value, double wanted, double kept) {
        const double ratio = std::pow(value / wanted, kept);
        if (!(std::abs(ratio - 1) > unseen && std::isfinite(ratio))) return;
        value = wanted * ratio;
        m_settled = false;
    }

    std::optional<Exposure> m_shown;
    double m_pixelsPerUnit = 1;
    Clock::time_point m_time;
    bool m_first = true;
    bool m_settled = true;
};

} // namespace

struct RenderThread::State {
    struct Job {
        RenderRequest request;
        std::uint64_t quality = 0;
        Brightness brightness = Brightness::OfThePicture;
    };

    explicit State(std::function<void()> ready) : frameReady(std::move(ready)), thread([this] { serve(); }) {}
    ~State() { mailbox.close(); }

    void serve();
    void work(Job job, const std::stop_token& stop);
    void show(double pixelsPerUnit, const std::stop_token& stop);
    void publish(Frame frame, const std::stop_token& stop);

    std::function<void()> frameReady;
    std::shared_ptr<FramePool> frames = std::make_shared<FramePool>();
    Mailbox<Job> mailbox;
    std::mutex mutex; // guards the two members below
    std::shared_ptr<const Frame> newest;
    bool announced = false;             // true between the calls of frameReady and newestFrame()
    std::optional<Rendering> rendering; // used by the worker only; its memory serves every request
    Adaptation adaptation;              // used by the worker only
    std::jthread thread;                // last member: uses the others
};

void RenderThread::State::serve() {
    while (auto delivery = mailbox.take())
        work(std::move(delivery->job), delivery->stop);
}

void RenderThread::State::work(Job job, const std::stop_token& stop) {
    const std::uint64_t first = std::max<std::uint64_t>(1, job.request.samples);
    const double pixelsPerUnit = job.request.camera.pixelsPerUnit;
    adaptation.begin(job.brightness);
    if (rendering)
        rendering->restart(std::move(job.request));
    else
        rendering.emplace(std::move(job.request));
    std::uint64_t done = 0;
    std::uint64_t pass = first;
    while (rendering->refine(stop, pass)) {
        show(pixelsPerUnit, stop);
        done += pass;
        if (done >= job.quality || rendering->finished()) break;
        // Pauses before refining, which would take the processors from the thread that shows the frame, and
        // replace that frame before the next change.
        if (done == pass && !mailbox.staysIdle(pauseBeforeRefining, stop)) return;
        pass = std::min({std::max(done, first), maxPass, job.quality - done});
    }
    while (!adaptation.settled() && mailbox.staysIdle(timeOfAFrame, stop))
        show(pixelsPerUnit, stop);
}

void RenderThread::State::show(double pixelsPerUnit, const std::stop_token& stop) {
    const Exposure wanted = rendering->exposure(stop);
    if (stop.stop_requested()) return; // measurement incomplete
    publish(rendering->frame(frames->take(), stop, adaptation.next(wanted, pixelsPerUnit)), stop);
}

void RenderThread::State::publish(Frame frame, const std::stop_token& stop) {
    std::shared_ptr<const Frame> shared = frames->shared(std::move(frame));
    {
        const std::lock_guard lock(mutex);
        if (stop.stop_requested()) return;
        newest.swap(shared); // the old value is released after the lock
        if (announced) return;
        announced = true;
    }
    frameReady();
}

RenderThread::RenderThread(std::function<void()> frameReady)
    : m_state(std::make_unique<State>(std::move(frameReady))) {}

RenderThread::~RenderThread() = default;

void RenderThread::submit(RenderRequest request, std::uint64_t quality, Brightness brightness) {
    m_state->mailbox.put(State::Job{std::move(request), quality, brightness});
}

void RenderThread::cancel() {
    m_state->mailbox.put(std::nullopt);
}

std::shared_ptr<const Frame> RenderThread::newestFrame() {
    const std::lock_guard lock(m_state->mutex);
    m_state->announced = false;
    return m_state->newest;
}

} // namespace attractor
