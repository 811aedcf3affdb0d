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
    double progress = 0; // 0 … 1 while the export is drawn
    // Estimate while the export is drawn, as soon as there is one.
    std::optional<qint64> millisecondsLeft = {};
};

// Exports that are drawn in the background, one after another, while one goes on editing. What is not done is
// kept in files: the next run of the program goes on with it, however this one ends. One for all windows of a
// process. docs/decisions/0025-exports-wait-in-files.md.
class ExportQueue : public QObject {
    Q_OBJECT

public:
    explicit ExportQueue(const QString& folder, QObject* parent = nullptr);
    ~ExportQueue() override; // stops the current export; the next run repeats it

    void resume();   // loads exports left by earlier runs
    void shutDown(); // stops for the end of the program; all exports are kept for the next run

    const std::vector<QueuedExport>& exports() const { return m_exports; } // order of the queue
    int unfinished() const; // exports that are waiting or being drawn
    bool isPaused() const { return m_isPaused; }
    bool isTarget(const QString& path) const; // true for an export that waits, is being drawn, or has failed

    // `task` without its place. The caller has asked about a file that is there.
    void add(io::ExportTask task);
    void setPaused(bool paused);          // also pauses the current export; stored between runs
    void cancel(const QString& id);       // removes the export without writing its file
    void retry(const QString& id);        // requires a failed export
    void move(const QString& id, int by); // offset of ±1; −1 is towards the front
    void forgetDone();

signals:
    void listChanged();          // sent for other exports or another order
    void exportChanged(int row); // sent for another state or progress
    void pausedChanged(bool paused);
    void resumed(int count); // number of exports left by earlier runs
    void message(const QString& sentence);

private:
    int rowOf(const QString& id) const; // −1: not in the queue
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
    bool m_hasComplained = false;       // true after the message that exports cannot be stored
    QElapsedTimer m_clock;              // running while an export is drawn
    qint64 m_earlier = 0;               // milliseconds of drawing before the last pause
    QString m_drawn;                    // id of the current export; empty: none
    std::unique_ptr<io::TaskJob> m_job; // last member: its thread uses the others
};

} // namespace view
