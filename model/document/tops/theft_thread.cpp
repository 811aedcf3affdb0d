// SPDX-License-Identifier: MIT
#include "document/tops/theft_thread.h"

#include "attractor/threads/mailbox.h"
#include "attractor/tops/deferred_theft.h"
#include "document/tops/laid_picture.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <thread>
#include <utility>

namespace document {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::uint64_t minPoints = 500'000, maxPoints = 10'000'000; // points during changes
constexpr std::uint64_t atRest[] = {16'000'000, 80'000'000};
// Milliseconds for both pictures while a hand moves: together with painting them, and with the variation
// between frames, they have to fit into a frame of the screen.
constexpr double fluid = 9;
constexpr double pictureBehind = 0.3; // opacity of the parts that are not on G
constexpr auto rest = std::chrono::milliseconds(60);

attractor::Frame frameOf(const TheftJob::Side& side, std::uint64_t points) {
    attractor::Frame frame;
    frame.revision = side.revision;
    frame.camera = side.camera;
    frame.pixels.resize(std::size_t(side.camera.width) * std::size_t(side.camera.height));
    frame.samples = points;
    frame.measure = 1;
    frame.passes = 1;
    return frame;
}

// Blends two premultiplied colours.
std::uint32_t mixed(std::uint32_t above, std::uint32_t below, double opacity) {
    const double through = 1 - opacity * double(above >> 24) / 255;
    std::uint32_t pixel = 0;
    for (const int shift : {0, 8, 16, 24})
        pixel |= std::uint32_t((above >> shift & 255) * opacity + (below >> shift & 255) * through + 0.5)
                 << shift;
    return pixel;
}

bool isShown(const TheftJob::Side& side) {
    return side.camera.width > 0 && side.camera.height > 0;
}

} // namespace

struct TheftThread::State {
    State(int threads, std::function<void()> callback)
        : ready(std::move(callback)),
          onFrom(threads),
          onTo(threads),
          over(threads),
          there(threads),
          thread([this] { serve(); }) {}
    ~State() { mailbox.close(); }

    void serve();
    void work(const TheftJob& job, const std::stop_token& stop);
    void adapt(double milliseconds);
    void couple(const TheftJob& job);
    bool show(const TheftJob& job, std::uint64_t points, const std::stop_token& stop);
    std::shared_ptr<const attractor::Frame> drawFrom(const TheftJob& job, const LaidPicture& laid,
                                                     std::uint64_t points, const std::stop_token& stop);
    std::shared_ptr<const attractor::Frame> drawTo(const TheftJob& job, const LaidPicture& laid,
                                                   std::uint64_t points, const std::stop_token& stop);
    bool overlay(attractor::Frame& frame, attractor::TheftRequest request, const LaidPicture& laid,
                 double opacity, const std::stop_token& stop);
    attractor::CoupledSystem identity() const; // identity on G
    void publish(StolenFrames frames, const std::stop_token& stop);

    std::function<void()> ready;
    attractor::Mailbox<TheftJob> mailbox;
    std::mutex mutex; // guards the two members below
    std::shared_ptr<const StolenFrames> newest;
    bool announced = false; // true between the calls of ready and newest()
    // Used by the worker only:
    std::shared_ptr<const Fractal> from, to; // fractals of `coupling`
    std::vector<std::size_t> order;
    CouplingOutcome coupling;
    attractor::DeferredTheft onFrom, onTo, over, there;
    // Last frame of G and its request: reused while only F changes.
    std::shared_ptr<const attractor::Frame> lastTo;
    std::vector<ifs::AffineMap<2>> lastMaps;
    LaidPicture lastLaid;
    attractor::Rgba lastBackground;
    std::uint64_t livePoints = 3'000'000;
    std::jthread thread; // last member: uses the others
};

void TheftThread::State::serve() {
    while (const auto delivery = mailbox.take())
        work(delivery->job, delivery->stop);
}

void TheftThread::State::work(const TheftJob& job, const std::stop_token& stop) {
    const auto begin = Clock::now();
    couple(job);
    if (!coupling.entries) return publish({nullptr, nullptr, coupling, job.number}, stop);
    if (!show(job, livePoints, stop)) return;
    const std::chrono::duration<double, std::milli> time = Clock::now() - begin;
    if (job.isLive) adapt(time.count());
    for (const std::uint64_t points : atRest)
        if (!mailbox.staysIdle(rest, stop) || !show(job, points, stop)) return;
}

// Adapts the number of points by half of the way each time: one slow picture on a busy machine must not make
// the grain jump. Small changes are skipped, because other points need other keys.
void TheftThread::State::adapt(double milliseconds) {
    const double now = double(livePoints), affordable = now * fluid / std::max(milliseconds, 0.1);
    const double next = std::clamp((now + affordable) / 2, double(minPoints), double(maxPoints));
    if (std::abs(next - now) > now / 4) livePoints = std::uint64_t(next);
}

void TheftThread::State::couple(const TheftJob& job) {
    if (job.from.fractal == from && job.to.fractal == to && job.order == order) return;
    from = job.from.fractal;
    to = job.to.fractal;
    order = job.order;
    coupling = coupled(*from, *to, order, coupling.entries);
}

bool TheftThread::State::show(const TheftJob& job, std::uint64_t points, const std::stop_token& stop) {
    const auto picture = laid(*coupling.entries, job.picture, job.mode, job.view, there, stop);
    if (!picture) return false;
    StolenFrames frames;
    frames.number = job.number;
    if (isShown(job.from)) frames.from = drawFrom(job, *picture, points, stop);
    if (stop.stop_requested()) return false;
    if (isShown(job.to)) frames.to = drawTo(job, *picture, points, stop);
    if (stop.stop_requested()) return false;
    publish(std::move(frames), stop);
    return true;
}

std::shared_ptr<const attractor::Frame> TheftThread::State::drawFrom(const TheftJob& job,
                                                                     const LaidPicture& laid,
                                                                     std::uint64_t points,
                                                                     const std::stop_token& stop) {
    const auto begin = Clock::now();
    attractor::Frame frame = frameOf(job.from, points);
    attractor::TheftRequest request;
    request.camera = job.from.camera;
    request.toPicture = laid.toPicture;
    request.points = points;
    request.background = from->appearance.background;
    if (!onFrom.draw(coupling.entries->system(), *laid.picture, request, frame.pixels, stop)) return nullptr;
    frame.opaque = request.background.alpha == 255;
    if (job.overlay > 0 && !overlay(frame, request, laid, job.overlay, stop)) return nullptr;
    const std::chrono::duration<double, std::milli> time = Clock::now() - begin;
    frame.milliseconds = time.count();
    return std::make_shared<const attractor::Frame>(std::move(frame));
}

// G with its picture where it lies in the plane of F, translucent.
bool TheftThread::State::overlay(attractor::Frame& frame, attractor::TheftRequest request,
                                 const LaidPicture& laid, double opacity, const std::stop_token& stop) {
    std::vector<std::uint32_t> above(frame.pixels.size());
    request.background = {0, 0, 0, 0};
    if (!over.draw(identity(), *laid.picture, request, above, stop)) return false;
    std::ranges::transform(above, frame.pixels, frame.pixels.begin(),
                           [opacity](std::uint32_t a, std::uint32_t b) { return mixed(a, b, opacity); });
    return true;
}

attractor::CoupledSystem TheftThread::State::identity() const {
    const ifs::SupportFunction<2>& attractor = coupling.entries->toAttractor;
    return {attractor, attractor, ifs::determinantWeights<2>(attractor.maps())};
}

// G as it is, through the identity, and the rest of the picture faintly behind it.
std::shared_ptr<const attractor::Frame> TheftThread::State::drawTo(const TheftJob& job,
                                                                   const LaidPicture& laid,
                                                                   std::uint64_t points,
                                                                   const std::stop_token& stop) {
    const auto& maps = coupling.entries->toAttractor.maps();
    const bool isSame = lastTo && lastTo->revision == job.to.revision && lastTo->camera == job.to.camera &&
                        lastMaps == maps && lastLaid.picture == laid.picture &&
                        lastLaid.toPicture == laid.toPicture && lastBackground == to->appearance.background;
    if (isSame && (points <= maxPoints || points <= lastTo->samples)) return lastTo;
    attractor::Frame frame = frameOf(job.to, points);
    attractor::TheftRequest request;
    request.camera = job.to.camera;
    request.toPicture = laid.toPicture;
    request.points = points;
    request.background = {0, 0, 0, 0};
    if (!onTo.draw(identity(), *laid.picture, request, frame.pixels, stop)) return nullptr;
    request.background = to->appearance.background;
    onTo.layUnder(frame.pixels, *laid.picture, request, pictureBehind);
    frame.opaque = true;
    lastTo = std::make_shared<const attractor::Frame>(std::move(frame));
    lastMaps = maps;
    lastLaid = laid;
    lastBackground = to->appearance.background;
    return lastTo;
}

void TheftThread::State::publish(StolenFrames frames, const std::stop_token& stop) {
    auto shared = std::make_shared<const StolenFrames>(std::move(frames));
    {
        const std::lock_guard lock(mutex);
        if (stop.stop_requested()) return;
        newest.swap(shared); // the old value is released after the lock
        if (std::exchange(announced, true)) return;
    }
    ready();
}

TheftThread::TheftThread(int threads, std::function<void()> ready)
    : m_state(std::make_unique<State>(threads, std::move(ready))) {}

TheftThread::~TheftThread() = default;

void TheftThread::submit(TheftJob job) {
    m_state->mailbox.put(std::move(job));
}

void TheftThread::cancel() {
    m_state->mailbox.put(std::nullopt);
}

std::shared_ptr<const StolenFrames> TheftThread::newest() {
    const std::lock_guard lock(m_state->mutex);
    m_state->announced = false;
    return m_state->newest;
}

} // namespace document
