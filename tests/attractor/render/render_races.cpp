// SPDX-License-Identifier: MIT
// The threads of the render core at work, without Qt, for the thread sanitizer. Returns 0 when all pictures
// agree.
#include "attractor/render/render_queue.h"
#include "attractor/render/render_thread.h"
#include "attractor/render/solid_rendering.h"
#include "attractor/space_systems.h"
#include "attractor/systems.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <vector>

using namespace attractor;

namespace {

// What another thread tells of.
class News {
public:
    void tell() {
        const std::lock_guard lock(m_mutex);
        m_told.notify_all();
    }
    // Asks again whenever something is told; for two minutes.
    bool waitFor(const auto& condition) {
        std::unique_lock lock(m_mutex);
        return m_told.wait_for(lock, std::chrono::minutes(2), condition);
    }

private:
    std::mutex m_mutex;
    std::condition_variable m_told;
};

RenderRequest numbered(std::uint64_t revision, int threads) {
    RenderRequest request = systems::request(systems::maple(), 300'000, 96, 64);
    request.revision = revision;
    request.threads = threads;
    return request;
}

bool threadsAgree() {
    return render(numbered(1, 1)).pixels == render(numbered(1, 4)).pixels;
}

// Under a cage that bends, all threads ask for the bends of the same words.
bool bentSolidsAgree() {
    SpaceRequest request = systems::spaceRequest(systems::menger(), 160, 512);
    std::vector<ifs::Vector<3>> corners;
    for (int k = 0; k < 8; ++k)
        corners.emplace_back(k & 1, k >> 1 & 1, k >> 2);
    request.cage = ifs::polygonAtRest<3>(corners);
    SolidRendering one(request);
    request.threads = 4;
    SolidRendering four(request);
    for (int frame = 0; frame < 3; ++frame) {
        request.cage->current[7] += ifs::Vector<3>(0.1, 0.2, 0.1);
        request.threads = 1;
        one.restart(request);
        request.threads = 4;
        four.restart(request);
        if (!one.draw() || !four.draw() || one.raster().keys != four.raster().keys) return false;
    }
    return true;
}

bool newestWins() {
    News frames;
    RenderThread thread([&] { frames.tell(); });
    for (std::uint64_t revision = 1; revision <= 60; ++revision) {
        thread.submit(numbered(revision, 3), 900'000);
        const auto frame = thread.newestFrame();
        if (frame && frame->revision > revision) return false;
        if (revision % 7 == 0) thread.cancel();
    }
    thread.submit(numbered(61, 3), 900'000);
    return frames.waitFor([&] {
        const auto frame = thread.newestFrame();
        return frame && frame->revision == 61 && frame->samples >= 900'000;
    });
}

bool queueFinishes() {
    News pictures;
    std::atomic<int> drawn = 0;
    RenderQueue queue;
    for (std::uint64_t key = 0; key < 20; ++key)
        queue.submit(key, {[key] { return numbered(key, 2); },
                           [&](const auto&) {
                               ++drawn;
                               pictures.tell();
                           }});
    return pictures.waitFor([&] { return drawn == 20; });
}

} // namespace

int main() {
    const bool passed = threadsAgree() && bentSolidsAgree() && newestWins() && queueFinishes();
    std::puts(passed ? "passed" : "failed");
    return passed ? 0 : 1;
}
