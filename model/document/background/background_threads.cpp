// SPDX-License-Identifier: MIT
#include "document/background/background_threads.h"

#include "document/background/lane_threads.h"

#include <QCoreApplication>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace document {

namespace {

using namespace std::chrono_literals;

using Clock = std::chrono::steady_clock;
using Lanes = std::array<LaneThreads*, 5>;

void finishWithTheApplication();

// Never destroyed, because threads that use it are not, either.
std::stop_source& end() {
    static auto* const made = new std::stop_source;
    return *made;
}

Lanes& lanes() {
    static Lanes made = [] {
        Lanes all{};
        for (LaneThreads*& lane : all)
            lane = new LaneThreads(threadsOfLane); // never destroyed
        qAddPostRoutine(finishWithTheApplication);
        return all;
    }();
    return made;
}

LaneThreads& threadsOf(Lane lane) {
    return *lanes()[std::size_t(lane)];
}

// Running jobs use Qt, which is about to be destroyed.
void finishWithTheApplication() {
    const Clock::time_point late = Clock::now() + 10s, early = Clock::now() + 5s;
    threadsOf(Lane::Saving).finish(late);
    for (const Lane lane : {Lane::Computing, Lane::Exporting})
        threadsOf(lane).finish(early);
    const Clock::time_point soon = Clock::now() + 1s;
    for (const Lane lane : {Lane::Asking, Lane::Reading})
        threadsOf(lane).finish(soon);
}

} // namespace

void startLanes() {
    lanes();
}

void startInLane(Lane lane, std::function<void()> work) {
    threadsOf(lane).start(std::move(work));
}

bool backgroundFinishes(std::chrono::milliseconds patience) {
    const Clock::time_point late = Clock::now() + patience;
    bool isDone = true;
    for (LaneThreads* lane : lanes())
        isDone = lane->finish(late) && isDone;
    return isDone;
}

bool laneFinishes(Lane lane, std::chrono::milliseconds patience) {
    return threadsOf(lane).finish(Clock::now() + patience);
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
