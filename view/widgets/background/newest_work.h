// SPDX-License-Identifier: MIT
#pragma once

#include "io/file/background.h"

#include <QFutureWatcher>

#include <functional>
#include <optional>
#include <stop_token>
#include <utility>

namespace view {

// Work in the background of which only the newest counts: one piece runs, and the newest that came meanwhile
// waits for it, unless it reads files: those may never answer, and the running piece is told to stop and its
// result is dropped. It ends with its owner: what runs then is told to stop.
template <class Result> class NewestWork {
public:
    using Work = std::function<std::optional<Result>(const std::stop_token&)>;

    // `done` gets each result, or nullopt when the work found none; not after cancel().
    explicit NewestWork(std::function<void(std::optional<Result>)> done, io::Lane lane = io::Lane::Computing)
        : m_done(std::move(done)), m_lane(lane) {
        QObject::connect(&m_watcher, &QFutureWatcherBase::finished, &m_watcher, [this] { finish(); });
    }
    ~NewestWork() { m_stop.request_stop(); }
    NewestWork(const NewestWork&) = delete;
    NewestWork& operator=(const NewestWork&) = delete;

    void submit(Work work) {
        if (m_lane == io::Lane::Reading) m_stop.request_stop();
        if (m_isRunning && m_lane != io::Lane::Reading)
            m_waiting = std::move(work);
        else
            start(std::move(work));
    }
    void cancel() {
        m_waiting = nullptr;
        m_isUnheard = m_isRunning;
        m_stop.request_stop();
    }
    bool isBusy() const { return m_isRunning && (!m_isUnheard || m_waiting); }

private:
    void start(Work work) {
        m_isRunning = true;
        m_isUnheard = false;
        m_stop = {};
        m_watcher.setFuture(io::inBackground<Result>(
            m_lane, [work = std::move(work), stop = m_stop.get_token()](QPromise<Result>& promise) {
                if (std::optional<Result> result = work(stop)) promise.addResult(std::move(*result));
            }));
    }
    void finish() {
        m_isRunning = false;
        const bool isHeard = !std::exchange(m_isUnheard, false);
        std::optional<Result> result;
        if (m_watcher.future().isResultReadyAt(0)) result = m_watcher.future().resultAt(0);
        if (m_waiting) start(std::exchange(m_waiting, nullptr));
        if (isHeard) m_done(std::move(result));
    }

    std::function<void(std::optional<Result>)> m_done;
    io::Lane m_lane;
    QFutureWatcher<Result> m_watcher;
    std::stop_source m_stop;
    Work m_waiting;
    bool m_isRunning = false;
    bool m_isUnheard = false; // true if cancelled while running
};

} // namespace view
