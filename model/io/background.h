// SPDX-License-Identifier: MIT
#pragma once

#include "document/let_go.h"

#include <QPromise>
#include <QThreadPool>

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

using document::letGo;

} // namespace io
