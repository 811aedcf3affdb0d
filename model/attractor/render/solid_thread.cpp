// SPDX-License-Identifier: MIT
#include "attractor/render/solid_thread.h"

#include "attractor/light/solid_light.h"
#include "attractor/render/cloud_rendering.h"
#include "attractor/render/live_step.h"
#include "attractor/render/solid_rendering.h"
#include "attractor/threads/mailbox.h"
#include "attractor/threads/workers.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <mutex>
#include <numbers>
#include <optional>
#include <thread>
#include <utility>

namespace attractor {

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr auto rest = std::chrono::milliseconds(100);
constexpr std::uint64_t samplesPerCell = 4; // samples of a density in one pass
constexpr std::uint64_t minPass = 200'000;
constexpr std::uint64_t maxSolidPass = 10'000'000;
constexpr int passesAtRest = 16;

// Offsets of the eyes to the right of the camera's.
std::vector<double> eyesOf(Stereo stereo) {
    if (stereo == Stereo::None) return {0};
    return {-stereoEye, stereoEye};
}

// The same view with one pixel for step × step, and enough of them to cover the picture.
OrbitCamera coarse(OrbitCamera camera, int step) {
    const RasterSize fine = camera.size;
    camera.size.width = (fine.width + step - 1) / step;
    camera.size.height = (fine.height + step - 1) / step;
    camera.height *= static_cast<double>(camera.size.height) * step / fine.height;
    if (camera.projection == OrbitCamera::Projection::Perspective) // keeps the eye in place
        camera.fieldOfView =
            2 / degree *
            std::atan(std::tan(camera.fieldOfView / 2 * degree) * camera.size.height * step / fine.height);
    return camera;
}

} // namespace

namespace {

double depthInRaster(const SolidFrame& frame, const ifs::Vector<2>& pixel) {
    const DepthRaster& raster = frame.raster;
    const auto cell = [&](double position, int cells, int pixels) {
        return std::floor((position - pixels / 2.0) / frame.step + cells / 2.0);
    };
    const double column = cell(pixel.x(), raster.width, frame.camera.size.width);
    const double row = cell(pixel.y(), raster.height, frame.camera.size.height);
    constexpr double nothing = std::numeric_limits<double>::infinity();
    if (!(column >= 0 && column < raster.width && row >= 0 && row < raster.height)) return nothing;
    const std::uint32_t key =
        raster.keys[static_cast<std::size_t>(row) * static_cast<std::size_t>(raster.width) +
                    static_cast<std::size_t>(column)];
    return key == emptyKey ? nothing : depthOf(raster, key);
}

} // namespace

// An eye to one side sees a point the more to the other side the farther it is behind the target.
double depthAt(const SolidFrame& frame, const ifs::Vector<2>& pixel) {
    double depth = depthInRaster(frame, pixel);
    if (frame.eyeShift == 0) return depth;
    constexpr int attempts = 8;
    const double unit = pixelsPerUnit(frame.camera);
    for (int k = 0; k < attempts && std::isfinite(depth); ++k) {
        double shift = frame.eyeShift * unit * depth;
        if (frame.camera.projection == OrbitCamera::Projection::Perspective) {
            const double distance = eyeDistance(frame.camera);
            shift *= distance / (distance + depth);
        }
        const double next = depthInRaster(frame, pixel + ifs::Vector<2>(shift, 0));
        if (next == depth) break;
        depth = next;
    }
    return depth;
}

struct SolidThread::State {
    explicit State(std::function<void()> ready) : frameReady(std::move(ready)), thread([this] { serve(); }) {}
    ~State() { mailbox.close(); }

    void serve();
    void work(const Job& job, const std::stop_token& stop);
    std::optional<double> show(const Job& job, int step, const std::stop_token& stop); // returns milliseconds
    bool showCloud(const Job& job, int step, SolidFrame frame, const std::stop_token& stop);
    bool drawEye(const SpaceRequest& request, double eyeShift, const std::stop_token& stop);
    void publish(SolidFrame frame, const std::stop_token& stop);

    std::function<void()> frameReady;
    Mailbox<Job> mailbox;
    std::mutex mutex; // guards the two members below
    std::shared_ptr<const SolidFrame> newest;
    bool announced = false; // true between the calls of frameReady and newestFrame()
    // Used by the worker only:
    std::optional<SolidRendering> rendering;
    std::array<std::optional<CloudRendering>, 2> clouds; // one for each eye
    std::optional<Workers> lamps;
    LiveStep live;       // used during changes
    std::jthread thread; // last member: uses the others
};

void SolidThread::State::serve() {
    while (const auto delivery = mailbox.take())
        work(delivery->job, delivery->stop);
}

void SolidThread::State::work(const Job& job, const std::stop_token& stop) {
    if (job.isLive) {
        const auto time = show(job, live.pixels(), stop);
        if (!time) return;
        live.took(*time);
        if (!mailbox.staysIdle(rest, stop)) return;
    }
    show(job, 1, stop);
}

std::optional<double> SolidThread::State::show(const Job& job, int step, const std::stop_token& stop) {
    const auto begin = std::chrono::steady_clock::now();
    SpaceRequest request = job.request;
    request.camera = coarse(request.camera, step);
    const double reach = request.camera.height / 2;
    const double middle = request.camera.target.y();
    const SolidView view = solidView(request.camera, middle - reach, middle + reach);
    const auto threads = static_cast<std::size_t>(std::max(1, request.threads));
    if (!lamps || lamps->size() != threads) lamps.emplace(threads);
    const std::vector<double> eyes = eyesOf(job.stereo);
    SolidFrame frame;
    if (!drawEye(request, eyes.front(), stop)) return std::nullopt;
    frame.revision = job.request.revision;
    frame.camera = job.request.camera;
    frame.stereo = job.stereo;
    frame.eyeShift = eyes.front();
    frame.step = step;
    frame.note = rendering->note();
    frame.isCoarse = !showsCloud(job.look) && rendering->work().isCoarse;
    frame.raster = rendering->takeRaster();
    if (showsCloud(job.look)) {
        if (!showCloud(job, step, std::move(frame), stop)) return std::nullopt;
        const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - begin;
        return spent.count();
    }
    frame.pixels = lit(frame.raster, job.appearance, view, *lamps);
    if (eyes.size() == 2) {
        if (!drawEye(request, eyes.back(), stop)) return std::nullopt;
        frame.pixels = joined(job.stereo, frame.pixels,
                              lit(rendering->takeRaster(), job.appearance, view, *lamps), frame.raster.width);
    }
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
    frame.milliseconds = time.count();
    publish(std::move(frame), stop);
    return time.count();
}

bool SolidThread::State::drawEye(const SpaceRequest& request, double eyeShift, const std::stop_token& stop) {
    SpaceRequest eye = request;
    eye.eyeShift = eyeShift;
    if (rendering)
        rendering->restart(std::move(eye));
    else
        rendering.emplace(std::move(eye));
    return rendering->draw(stop);
}

// Shows a cloud pass by pass, once the hand rests. The solid behind it tells which point is under the
// pointer.
bool SolidThread::State::showCloud(const Job& job, int step, SolidFrame frame, const std::stop_token& stop) {
    const auto begin = std::chrono::steady_clock::now();
    SpaceRequest request = job.request;
    request.camera = coarse(request.camera, step);
    const std::size_t cells = frame.raster.keys.size();
    request.samples = std::clamp<std::uint64_t>(cells * samplesPerCell, minPass, maxSolidPass);
    const std::vector<double> eyes = eyesOf(job.stereo);
    for (std::size_t k = 0; k < eyes.size(); ++k) {
        request.eyeShift = eyes[k];
        if (clouds[k])
            clouds[k]->restart(request);
        else
            clouds[k].emplace(request);
    }
    const int passes = step > 1 ? 1 : passesAtRest;
    for (int pass = 1; pass <= passes; ++pass) {
        SolidFrame next = frame;
        std::array<std::vector<std::uint32_t>, 2> seen;
        for (std::size_t k = 0; k < eyes.size(); ++k) {
            seen[k].resize(cells);
            if (!clouds[k]->refine(stop) || !clouds[k]->tone(seen[k], stop)) return false;
        }
        next.pixels =
            eyes.size() == 2 ? joined(job.stereo, seen[0], seen[1], frame.raster.width) : std::move(seen[0]);
        const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
        next.milliseconds = time.count();
        publish(std::move(next), stop);
    }
    return true;
}

void SolidThread::State::publish(SolidFrame frame, const std::stop_token& stop) {
    auto shared = std::make_shared<const SolidFrame>(std::move(frame));
    {
        const std::lock_guard lock(mutex);
        if (stop.stop_requested()) return;
        newest.swap(shared); // the old value is released after the lock
        if (std::exchange(announced, true)) return;
    }
    frameReady();
}

SolidThread::SolidThread(std::function<void()> frameReady)
    : m_state(std::make_unique<State>(std::move(frameReady))) {}

SolidThread::~SolidThread() = default;

void SolidThread::submit(Job job) {
    m_state->mailbox.put(std::move(job));
}

void SolidThread::cancel() {
    m_state->mailbox.put(std::nullopt);
}

std::shared_ptr<const SolidFrame> SolidThread::newestFrame() {
    const std::lock_guard lock(m_state->mutex);
    m_state->announced = false;
    return m_state->newest;
}

} // namespace attractor
