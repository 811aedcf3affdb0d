// SPDX-License-Identifier: MIT
#include "attractor/render/render_queue.h"
#include "attractor/render/render_thread.h"
#include "attractor/systems.h"
#include "support/late_stop.h"
#include "support/named_test.h"

#include <QtTest>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <ctime>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

using namespace attractor;

namespace {

// Waits for a condition that another thread brings about; fails the test after a minute.
template <class Condition> bool eventually(Condition condition) {
    return QTest::qWaitFor(condition, 60'000);
}

bool reaches(RenderThread& thread, std::uint64_t samples) {
    const auto frame = thread.newestFrame();
    return frame && frame->samples >= samples;
}

// No thread of the process works. That is measured over a fixed time, as there is no event to wait for.
bool rests() {
    const std::clock_t before = std::clock();
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    return double(std::clock() - before) / CLOCKS_PER_SEC < 0.01;
}

constexpr std::uint64_t usual = 20'000;

RenderRequest numbered(std::uint64_t revision, std::uint64_t samples = usual) {
    RenderRequest request = systems::request(systems::maple(), samples, 64, 48);
    request.revision = revision;
    return request;
}

} // namespace

class TestRenderThread : public QObject {
    Q_OBJECT

private slots:
    void theNewestRequestWins() {
        std::atomic<int> announced = 0;
        RenderThread thread([&] { ++announced; });
        QVERIFY(thread.newestFrame() == nullptr);
        for (std::uint64_t revision = 1; revision <= 200; ++revision)
            thread.submit(numbered(revision), 20'000);
        QVERIFY(eventually([&] {
            const auto frame = thread.newestFrame();
            return frame && frame->revision == 200;
        }));
        QVERIFY(announced <= 200);
        QVERIFY(thread.newestFrame()->pixels == render(numbered(200)).pixels);
    }

    void neverAnnouncesTwiceBeforeTheFrameIsTaken() {
        std::atomic<int> announced = 0;
        RenderThread thread([&] { ++announced; });
        thread.submit(numbered(1), 2'000'000);
        QVERIFY(eventually([&] { return announced == 1; }));
        std::shared_ptr<const Frame> frame;
        RenderThread another([] {});
        another.submit(numbered(2), 2'000'000);
        QVERIFY(eventually([&] { return reaches(another, 2'000'000); })); // meanwhile
        QCOMPARE(announced.load(), 1); // passes went on without a second call
        QVERIFY(eventually([&] {
            frame = thread.newestFrame();
            return frame->samples >= 2'000'000;
        }));
    }

    void refinesToTheQualityAskedAndStops() {
        RenderThread thread([] {});
        thread.submit(numbered(1), 500'000);
        QVERIFY(eventually([&] { return reaches(thread, 500'000); }));
        RenderThread another([] {});
        another.submit(numbered(2), 2'000'000);
        QVERIFY(eventually([&] { return reaches(another, 2'000'000); })); // meanwhile
        QCOMPARE(thread.newestFrame()->samples, std::uint64_t{500'000});
        QVERIFY(thread.newestFrame()->passes > 2);
    }

    void restsWhenThereIsNothingLeftToDo() {
        RenderThread thread([] {});
        for (const auto brightness :
             {RenderThread::Brightness::OfThePicture, RenderThread::Brightness::Eased}) {
            thread.submit(numbered(1), 500'000, brightness);
            QVERIFY(eventually([&] { return reaches(thread, 500'000); }));
            QVERIFY(eventually(rests)); // once brightness has settled
        }
    }

    // A set thinner than the plane is brighter the closer one looks; that must not be seen as a step.
    void brightnessEasesWhileZooming() {
        std::mutex mutex;
        std::vector<std::shared_ptr<const Frame>> frames;
        RenderThread* source = nullptr;
        RenderThread thread([&] {
            const std::lock_guard lock(mutex);
            frames.push_back(source->newestFrame());
        });
        source = &thread;
        const auto newest = [&] {
            const std::lock_guard lock(mutex);
            return frames.empty() ? nullptr : frames.back();
        };
        RenderRequest request = systems::request(systems::sierpinski(), 400'000, 64, 48);
        request.revision = 1;
        thread.submit(request, 1);
        QVERIFY(eventually([&] { return newest() != nullptr; }));
        request.revision = 2;
        request.camera = zoomedAt(request.camera, {20, 30}, 4);
        thread.submit(request, 1, RenderThread::Brightness::Eased);
        const Frame after = render(request);
        QVERIFY(eventually([&] { return newest()->shown == after.exposure; }));
        QVERIFY(newest()->pixels == after.pixels);

        std::vector<double> way; // from the density before to the one after, in the plane
        const auto density = [](const Frame& frame) {
            return std::log(frame.shown.meanDensity * std::pow(frame.camera.pixelsPerUnit, 2));
        };
        const double whole = density(after) - density(*frames[0]);
        QVERIFY(std::abs(whole) > 0.1);
        for (const auto& frame : frames)
            way.push_back((density(*frame) - density(*frames[0])) / whole);
        QVERIFY2(way[1] > 0 && way[1] < 0.25, qPrintable(QString::number(way[1])));
        QVERIFY(std::is_sorted(way.begin(), way.end()));

        request.camera = zoomedAt(request.camera, {20, 30}, 0.25);
        request.revision = 3;
        thread.submit(request, 1); // another document, say: at once
        QVERIFY(eventually([&] { return newest()->revision == 3; }));
        const auto back = std::find_if(frames.begin(), frames.end(),
                                       [](const auto& frame) { return frame->revision == 3; });
        QCOMPARE((*back)->shown, render(request).exposure);
    }

    // By work, not by time: of a pass that would take minutes, hardly anything is done after the stop.
    void abandonsAPassAtOnce() {
        constexpr std::uint64_t endless = 1'000'000'000'000;
        std::mutex mutex;
        std::vector<std::uint64_t> revisions; // of the frames that came
        RenderThread* source = nullptr;
        RenderThread thread([&] {
            const std::lock_guard lock(mutex);
            revisions.push_back(source->newestFrame()->revision);
        });
        source = &thread;
        const auto comes = [&](std::uint64_t revision) {
            return eventually([&] {
                const std::lock_guard lock(mutex);
                return !revisions.empty() && revisions.back() == revision;
            });
        };
        thread.submit(numbered(1, endless), 1);
        thread.submit(numbered(2), 1);
        QVERIFY(comes(2));
        thread.submit(numbered(3, endless), 1);
        thread.cancel();
        QCOMPARE(thread.newestFrame()->revision, std::uint64_t{2});
        thread.submit(numbered(4), 1);
        QVERIFY(comes(4));
        QCOMPARE(revisions, (std::vector<std::uint64_t>{2, 4}));
        thread.submit(numbered(5, endless), 1);
    } // and the destructor does not wait for revision 5

    void aStopIsSeenBetweenTwoJobs() {
        Rendering rendering(numbered(1, 1'000'000'000'000));
        const support::LateStop stop(std::chrono::milliseconds(5));
        QVERIFY(!rendering.refine(stop.token()));
    }

    void queueDrawsInOrder() {
        std::mutex mutex;
        std::vector<std::uint64_t> keys;
        RenderQueue queue;
        for (std::uint64_t key = 1; key <= 20; ++key)
            queue.submit(key, {[key] { return numbered(key); },
                               [&, key](const std::shared_ptr<const Frame>& frame) {
                                   const std::lock_guard lock(mutex);
                                   if (frame->pixels.size() == 64 * 48) keys.push_back(key);
                               }});
        QVERIFY(eventually([&] {
            const std::lock_guard lock(mutex);
            return keys.size() == 20;
        }));
        for (std::uint64_t key = 1; key <= 20; ++key)
            QCOMPARE(keys[key - 1], key);
    }

    void requestsAreMadeWhereTheyAreDrawn() {
        std::atomic<bool> isElsewhere = false;
        std::atomic<bool> isNothing = false;
        RenderQueue queue;
        queue.submit(1, {[&, here = std::this_thread::get_id()]() -> std::optional<RenderRequest> {
                             isElsewhere = std::this_thread::get_id() != here;
                             return std::nullopt;
                         },
                         [&](const std::shared_ptr<const Frame>& frame) { isNothing = !frame; }});
        QVERIFY(eventually([&] { return isNothing.load(); }));
        QVERIFY(isElsewhere);
    }

    void cancelledRequestsAreNotDrawn() {
        std::mutex mutex;
        std::set<std::uint64_t> keys;
        RenderQueue queue;
        const auto submit = [&](std::uint64_t key, std::uint64_t samples = usual) {
            queue.submit(key, {[=] { return numbered(key, samples); },
                               [&, key](const auto&) {
                                   const std::lock_guard lock(mutex);
                                   keys.insert(key);
                               }});
        };
        submit(1, 1'000'000'000'000); // keeps the thread busy
        submit(2);
        submit(3);
        queue.cancel(2);
        queue.cancel(1);
        QVERIFY(eventually([&] {
            const std::lock_guard lock(mutex);
            return keys.contains(3);
        }));
        QVERIFY(!keys.contains(1) && !keys.contains(2));
        submit(4, 1'000'000'000'000);
        submit(5);
        queue.clear();
        submit(6);
        QVERIFY(eventually([&] {
            const std::lock_guard lock(mutex);
            return keys.contains(6);
        }));
        QVERIFY(!keys.contains(4) && !keys.contains(5));
    }
};

BARYCAGE_TEST(TestRenderThread);
#include "render_thread_test.moc"
