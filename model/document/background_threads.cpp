// SPDX-License-Identifier: MIT
#include "document/background_threads.h"

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QThreadPool>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace document {

namespace {

using namespace std::chrono_literals;

using Pools = std::array<QThreadPool, 4>; // of each lane

bool finish(QThreadPool& pool, const QDeadlineTimer& end) {
    return pool.waitForDone(int(end.remainingTime()));
}

void finishWithTheApplication();

// Never destroyed: what hangs must not hold up the end of the program.
Pools& pools() {
    static auto* const made = [] {
        auto* all = new Pools;
        for (QThreadPool& pool : *all)
            pool.setMaxThreadCount(threadsOfLane);
        qAddPostRoutine(finishWithTheApplication);
        return all;
    }();
    return *made;
}

QThreadPool& poolOf(Lane lane) {
    return pools()[std::size_t(lane)];
}

// What is under way uses Qt, which is about to go.
void finishWithTheApplication() {
    finish(poolOf(Lane::Saving), QDeadlineTimer(10s));
    finish(poolOf(Lane::Computing), QDeadlineTimer(5s));
    const QDeadlineTimer soon(1s);
    for (const Lane lane : {Lane::Asking, Lane::Reading})
        finish(poolOf(lane), soon);
}

} // namespace

void startInLane(Lane lane, std::function<void()> work) {
    poolOf(lane).start(std::move(work));
}

bool backgroundFinishes(std::chrono::milliseconds patience) {
    const QDeadlineTimer end(patience);
    bool isDone = true;
    for (QThreadPool& pool : pools())
        isDone = finish(pool, end) && isDone;
    return isDone;
}

void quickExit(int status) {
    std::fflush(nullptr);
    std::_Exit(status);
}

} // namespace document
