// SPDX-License-Identifier: MIT
#pragma once

#include "document/free_in_background.h"

#include <QDeadlineTimer>
#include <QFuture>
#include <QPromise>
#include <QThread>
#include <QThreadPool>

#include <chrono>
#include <exception>
#include <memory>
#include <utility>

namespace io {

// Runs work(QPromise<Result>&) in a thread of its own, beside the window. Cancelling the future tells the
// work to end; what nobody waits for any more goes on unheard, but not beyond the end of the program.
template <class Result, class Work> QFuture<Result> inBackground(Work work) {
    const auto promise = std::make_shared<QPromise<Result>>(); // a function that may be copied holds it
    QFuture<Result> future = promise->future();
    promise->start();
    QThreadPool::globalInstance()->start([promise, work = std::move(work)]() mutable {
        try {
            work(*promise);
        } catch (...) { // memory may be short
            promise->setException(std::current_exception());
        }
        promise->finish();
    });
    return future;
}

// Waits for the work, but no longer than that.
template <class Result> bool finishesWithin(std::chrono::milliseconds patience, const QFuture<Result>& work) {
    for (const QDeadlineTimer moment(patience); !work.isFinished() && !moment.hasExpired();)
        QThread::yieldCurrentThread();
    return work.isFinished();
}

using document::freeInBackground;

} // namespace io
