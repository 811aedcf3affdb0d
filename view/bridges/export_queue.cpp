// SPDX-License-Identifier: MIT
#include "bridges/export_queue.h"

#include "desktop/settings.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <chrono>
#include <utility>

namespace view {

namespace {

using State = QueuedExport::State;

const QString pausedKey = QStringLiteral("exports/paused");
constexpr int maxBegun = 2;         // attempts; a third one would probably end the program, too
constexpr double minShare = 0.02;   // share done before the remaining time is estimated
constexpr qint64 minPatience = 700; // milliseconds
constexpr std::chrono::milliseconds oftenEnough{100}; // interval of progress reports

} // namespace

ExportQueue::ExportQueue(const QString& folder, QObject* parent)
    : QObject(parent), m_store(folder), m_isPaused(stored(pausedKey, false).toBool()) {}

ExportQueue::~ExportQueue() {
    shutDown();
}

void ExportQueue::resume() {
    m_store.takeOver([this](const io::TaskFolder::TakenOver& taken) {
        QMetaObject::invokeMethod(
            this, [this, taken] { takeOver(taken); }, Qt::QueuedConnection);
    });
}

void ExportQueue::takeOver(const io::TaskFolder::TakenOver& taken) {
    if (m_isShutDown) return;
    for (const QString& sentence : taken.skipped)
        emit message(sentence);
    if (taken.tasks.isEmpty()) return;
    std::vector<QueuedExport> left;
    for (const auto& [id, task] : taken.tasks) {
        QueuedExport one{id, task, task.failure.isEmpty() ? State::Waiting : State::Failed};
        if (one.state == State::Waiting && task.begun >= maxBegun) {
            one.state = State::Failed;
            one.task.failure = tr("Barycage ended unexpectedly twice while drawing this picture. Try it "
                                  "again alone, or export a smaller one.");
        }
        left.push_back(std::move(one));
    }
    m_exports.insert(m_exports.begin(), left.begin(), left.end());
    // Appends exports that were added meanwhile.
    for (std::size_t k = 0; k < m_exports.size(); ++k)
        if (std::exchange(m_exports[k].task.place, qint64(k)) != qint64(k)) keep(m_exports[k]);
    emit listChanged();
    emit resumed(int(left.size()));
    startNext();
}

void ExportQueue::shutDown() {
    if (std::exchange(m_isShutDown, true)) return;
    m_job.reset();
    if (const int row = rowOf(m_drawn); row >= 0 && m_exports[std::size_t(row)].state == State::Drawing) {
        QueuedExport& drawn = m_exports[std::size_t(row)];
        drawn.state = State::Waiting;
        drawn.task.begun = 0; // the export did not cause the end
        keep(drawn);
    }
    m_store.letGo();
}

int ExportQueue::rowOf(const QString& id) const {
    const auto found = std::ranges::find(m_exports, id, &QueuedExport::id);
    return found == m_exports.end() ? -1 : int(found - m_exports.begin());
}

int ExportQueue::unfinished() const {
    return int(std::ranges::count_if(m_exports, [](const QueuedExport& one) {
        return one.state == State::Waiting || one.state == State::Drawing;
    }));
}

bool ExportQueue::isTarget(const QString& path) const {
    const QString wanted = QDir::cleanPath(QFileInfo(path).absoluteFilePath());
    return std::ranges::any_of(m_exports, [&](const QueuedExport& one) {
        return one.state != State::Done && QDir::cleanPath(one.task.path) == wanted;
    });
}

void ExportQueue::keep(const QueuedExport& one) {
    m_store.write(one.id, one.task, [this](bool isKept) {
        QMetaObject::invokeMethod(
            this,
            [this, isKept] {
                if (!isKept && !std::exchange(m_hasComplained, true))
                    emit message(tr("The export queue cannot be saved for the next session: its folder is "
                                    "not writable, or the disk is full."));
                if (isKept) m_hasComplained = false;
            },
            Qt::QueuedConnection);
    });
}

void ExportQueue::add(io::ExportTask task) {
    task.path = QDir::cleanPath(QFileInfo(task.path).absoluteFilePath());
    task.place = m_exports.empty() ? 0 : m_exports.back().task.place + 1;
    m_exports.push_back({io::TaskFolder::newId(), std::move(task)});
    keep(m_exports.back());
    emit listChanged();
    startNext();
}

void ExportQueue::startNext() {
    if (!m_drawn.isEmpty() || m_isPaused || m_isShutDown) return;
    const auto next = std::ranges::find(m_exports, State::Waiting, &QueuedExport::state);
    if (next != m_exports.end()) start(*next);
}

void ExportQueue::start(QueuedExport& next) {
    next.state = State::Drawing;
    next.progress = 0;
    next.millisecondsLeft.reset();
    ++next.task.begun;
    keep(next);
    m_drawn = next.id;
    m_earlier = 0;
    m_clock.start();
    m_job = std::make_unique<io::TaskJob>(
        next.task,
        [this, id = next.id, last = std::chrono::steady_clock::time_point()](double fraction) mutable {
            const auto now = std::chrono::steady_clock::now();
            if (now - last < oftenEnough) return;
            last = now;
            QMetaObject::invokeMethod(
                this, [this, id, fraction] { advance(id, fraction); }, Qt::QueuedConnection);
        },
        [this, id = next.id](const io::TaskJob::Outcome& outcome) {
            QMetaObject::invokeMethod(
                this, [this, id, outcome] { finish(id, outcome); }, Qt::QueuedConnection);
        });
    emit exportChanged(rowOf(next.id));
}

void ExportQueue::advance(const QString& id, double fraction) {
    const int row = rowOf(id);
    if (row < 0 || id != m_drawn) return;
    QueuedExport& drawn = m_exports[std::size_t(row)];
    drawn.progress = std::clamp(fraction, 0.0, 1.0);
    const qint64 passed = m_earlier + (m_isPaused ? 0 : m_clock.elapsed());
    if (fraction >= minShare && passed >= minPatience)
        drawn.millisecondsLeft = qint64(double(passed) * (1 - fraction) / fraction);
    emit exportChanged(row);
}

void ExportQueue::finish(const QString& id, const io::TaskJob::Outcome& outcome) {
    if (id != m_drawn || m_isShutDown) return;
    m_job.reset();
    m_drawn.clear();
    if (const int row = rowOf(id); row >= 0) {
        QueuedExport& drawn = m_exports[std::size_t(row)];
        drawn.task.begun = 0;
        drawn.millisecondsLeft.reset();
        drawn.state = outcome.failure ? State::Failed : outcome.stopped ? State::Waiting : State::Done;
        if (outcome.failure) {
            drawn.task.failure = *outcome.failure;
            // The message tells that the file exists now.
            drawn.task.mayReplace = drawn.task.mayReplace || outcome.isTaken;
            keep(drawn);
        } else if (drawn.state == State::Done) {
            drawn.progress = 1;
            drawn.task.entry.clear();
            m_store.remove(id);
        }
        emit exportChanged(row);
    }
    startNext();
}

void ExportQueue::setPaused(bool paused) {
    if (std::exchange(m_isPaused, paused) == paused) return;
    store(pausedKey, paused);
    if (m_job) {
        if (paused)
            m_earlier += m_clock.elapsed();
        else
            m_clock.restart();
        m_job->setPaused(paused);
        emit exportChanged(rowOf(m_drawn));
    }
    emit pausedChanged(paused);
    startNext();
}

void ExportQueue::cancel(const QString& id) {
    const int row = rowOf(id);
    if (row < 0) return;
    if (id == m_drawn) m_job->stop(); // the next export begins after the end of this one
    if (m_exports[std::size_t(row)].state != State::Done) m_store.remove(id);
    m_exports.erase(m_exports.begin() + row);
    emit listChanged();
    startNext();
}

void ExportQueue::retry(const QString& id) {
    const int row = rowOf(id);
    if (row < 0 || m_exports[std::size_t(row)].state != State::Failed) return;
    QueuedExport& again = m_exports[std::size_t(row)];
    again.state = State::Waiting;
    again.task.failure.clear();
    again.task.begun = 0;
    keep(again);
    emit exportChanged(row);
    startNext();
}

void ExportQueue::move(const QString& id, int by) {
    const int from = rowOf(id), to = from + by;
    if (from < 0 || to < 0 || to >= int(m_exports.size()) || by == 0) return;
    QueuedExport& one = m_exports[std::size_t(from)];
    QueuedExport& other = m_exports[std::size_t(to)];
    std::swap(one.task.place, other.task.place);
    std::swap(one, other);
    for (const QueuedExport* moved : {&one, &other})
        if (moved->state != State::Done) keep(*moved);
    emit listChanged();
}

void ExportQueue::forgetDone() {
    std::erase_if(m_exports, [](const QueuedExport& one) { return one.state == State::Done; });
    emit listChanged();
}

} // namespace view
