// SPDX-License-Identifier: MIT
#include "document/background/background_threads.h"

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

using Pools = std::array<QThreadPool, 5>; // of each lane

bool finish(QThreadPool& pool, const QDeadlineTimer& late) {
    return pool.waitForDone(int(late.remainingTime()));
}

void finishWithTheApplication();

// Never destroyed, as those who ask are not.
std::stop_source& end() {
    static auto* const made = new std::stop_source;
    return *made;
}

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
    const QDeadlineTimer late(10s), early(5s);
    finish(poolOf(Lane::Saving), late);
    for (const Lane lane : {Lane::Computing, Lane::Exporting})
        finish(poolOf(lane), early);
    const QDeadlineTimer soon(1s);
    for (const Lane lane : {Lane::Asking, Lane::Reading})
        finish(poolOf(lane), soon);
}

} // namespace

void startInLane(Lane lane, std::function<void()> work) {
    poolOf(lane).start(std::move(work));
}

bool backgroundFinishes(std::chrono::milliseconds patience) {
    const QDeadlineTimer late(patience);
    bool isDone = true;
    for (QThreadPool& pool : pools())
        isDone = finish(pool, late) && isDone;
    return isDone;
}

bool laneFinishes(Lane lane, std::chrono::milliseconds patience) {
    return finish(poolOf(lane), QDeadlineTimer(patience));
}

std::stop_token endOfProgram() {
    return end().get_token();
}

void announceEnd() {
    end().request_stop();
}

void quickExit(int status) {
    std::fflush(nullptr);
    std::_Exit(status);
}

} // namespace document
