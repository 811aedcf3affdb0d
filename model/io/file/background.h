// SPDX-License-Identifier: MIT
#pragma once

#include "document/background/background_threads.h"
#include "document/background/free_in_background.h"

#include <QDeadlineTimer>
#include <QFuture>
#include <QPromise>
#include <QThread>

#include <chrono>
#include <exception>
#include <memory>
#include <utility>

namespace io {

using document::Lane;

// Runs work(QPromise<Result>&) in a thread of its own, beside the window; work on files is never in the lane
// of other work. Cancelling the future tells the work to end; work whose result nobody waits for any more
// goes on, perhaps beyond the end of the program, so it must hold nothing but values.
template <class Result, class Work> QFuture<Result> inBackground(Lane lane, Work work) {
    const auto promise = std::make_shared<QPromise<Result>>(); // shared, since std::function must be copyable
    QFuture<Result> future = promise->future();
    promise->start();
    document::startInLane(lane, [promise, work = std::move(work)]() mutable {
        try {
            work(*promise);
        } catch (...) { // such as std::bad_alloc
            promise->setException(std::current_exception());
        }
        promise->finish();
    });
    return future;
}

// The same for work that touches no file.
template <class Result, class Work> QFuture<Result> inBackground(Work work) {
    return inBackground<Result>(Lane::Computing, std::move(work));
}

// Waits for the work, but no longer than that.
template <class Result> bool finishesWithin(std::chrono::milliseconds patience, const QFuture<Result>& work) {
    for (const QDeadlineTimer moment(patience); !work.isFinished() && !moment.hasExpired();)
        QThread::yieldCurrentThread();
    return work.isFinished();
}

using document::freeInBackground;

} // namespace io
