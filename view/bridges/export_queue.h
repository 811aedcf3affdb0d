// SPDX-License-Identifier: MIT
#pragma once

#include "io/exports/export_task.h"
#include "io/exports/task_job.h"
#include "io/exports/task_store.h"

#include <QElapsedTimer>
#include <QObject>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace view {

// An export in the queue.
struct QueuedExport {
    enum class State { Waiting, Drawing, Failed, Done };

    QString id;
    io::ExportTask task;
    State state = State::Waiting;
    double progress = 0;                         // 0 … 1 of one that is drawn
    std::optional<qint64> millisecondsLeft = {}; // of one that is drawn, once that can be told
};

// Exports that are drawn in the background, one after another, while one goes on editing. What is not done is
// kept in files: the next run of the program goes on with it, however this one ends. One for all windows of a
// process. docs/decisions/0025-exports-wait-in-files.md.
class ExportQueue : public QObject {
    Q_OBJECT

public:
    explicit ExportQueue(const QString& folder, QObject* parent = nullptr);
    ~ExportQueue() override; // stops the current export; the next run repeats it

    void resume();   // with what earlier runs have left
    void shutDown(); // the program ends: what is drawn stops, and all is kept for the next run

    const std::vector<QueuedExport>& exports() const { return m_exports; } // in their order
    int unfinished() const;                                                // waiting or drawn
    bool isPaused() const { return m_isPaused; }
    bool isTarget(const QString& path) const; // of one that waits, is drawn, or can be tried again

    // `task` without its place. The caller has asked about a file that is there.
    void add(io::ExportTask task);
    void setPaused(bool paused);          // also what is drawn now; kept between runs
    void cancel(const QString& id);       // and forget; nothing is written any more
    void retry(const QString& id);        // one that has failed
    void move(const QString& id, int by); // by one place: −1 towards the front
    void forgetDone();

signals:
    void listChanged();          // which there are, or their order
    void exportChanged(int row); // its state or progress
    void pausedChanged(bool paused);
    void resumed(int count); // so many were left by earlier runs
    void message(const QString& sentence);

private:
    int rowOf(const QString& id) const; // −1: it is gone
    void startNext();
    void start(QueuedExport& next);
    void advance(const QString& id, double fraction);
    void finish(const QString& id, const io::TaskJob::Outcome& outcome);
    void takeOver(const io::TaskFolder::TakenOver& taken);
    void keep(const QueuedExport& one);

    io::TaskStore m_store;
    std::vector<QueuedExport> m_exports;
    bool m_isPaused = false;
    bool m_isShutDown = false;
    bool m_hasComplained = false;       // that nothing can be kept
    QElapsedTimer m_clock;              // while something is drawn
    qint64 m_earlier = 0;               // milliseconds that it was drawn before the last pause
    QString m_drawn;                    // its id; empty: nothing is drawn
    std::unique_ptr<io::TaskJob> m_job; // last: stops before the rest goes
};

} // namespace view
