// SPDX-License-Identifier: MIT
#include "dialogs/export/cluster_queue.h"

#include "io/animation/cluster_job.h"
#include "io/file/slow_disk.h"

#include <QMap>
#include <QRegularExpression>
#include <QStandardPaths>

#include <algorithm>
#include <chrono>
#include <numeric>

namespace view {

namespace {

constexpr std::chrono::seconds askEvery{2};

// Number of tasks of a job by state; states are Slurm's own, such as RUNNING.
using States = QMap<QString, int>;

int count(const States& states, std::initializer_list<const char*> names) {
    int sum = 0;
    for (const char* name : names)
        sum += states.value(QLatin1String(name));
    return sum;
}

struct Counts {
    int done = 0, running = 0, waiting = 0, failed = 0;
    int all() const { return done + running + waiting + failed; }
};

Counts counted(const States& states) {
    Counts counts;
    counts.done = count(states, {"COMPLETED"});
    counts.running = count(states, {"RUNNING", "COMPLETING", "CONFIGURING", "STAGE_OUT", "SIGNALING"});
    counts.waiting = count(states, {"PENDING", "REQUEUED", "REQUEUE_HOLD", "REQUEUE_FED", "SUSPENDED",
                                    "STOPPED", "RESIZING", "SPECIAL_EXIT"});
    const QList<int> every = states.values();
    counts.failed = std::accumulate(every.begin(), every.end(), 0) - counts.all();
    return counts;
}

QString drawingText(const Counts& counts) {
    QStringList parts{ClusterQueue::tr("%1 of %2 done").arg(counts.done).arg(counts.all())};
    if (counts.running > 0) parts << ClusterQueue::tr("%1 running").arg(counts.running);
    if (counts.waiting > 0) parts << ClusterQueue::tr("%1 waiting").arg(counts.waiting);
    if (counts.failed > 0) parts << ClusterQueue::tr("%1 failed").arg(counts.failed);
    return ClusterQueue::tr("Drawing: %1.").arg(parts.join(QStringLiteral(", ")));
}

QString videoText(const Counts& counts) {
    if (counts.done > 0) return ClusterQueue::tr("Video: done.");
    if (counts.failed > 0) return ClusterQueue::tr("Video: failed.");
    return counts.running > 0 ? ClusterQueue::tr("Video: running.") : ClusterQueue::tr("Video: waiting.");
}

} // namespace

ClusterQueue::ClusterQueue(QObject* parent) : QObject(parent) {
    m_timer.setInterval(askEvery);
    connect(&m_timer, &QTimer::timeout, this, &ClusterQueue::ask);
    connect(&m_submission, &QProcess::finished, this, &ClusterQueue::takeSubmitted);
    connect(&m_submission, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart) fail(m_submission.errorString());
    });
    connect(&m_question, &QProcess::finished, this, &ClusterQueue::takeStates);
}

// Gives a submission under way a moment to arrive at Slurm whole.
ClusterQueue::~ClusterQueue() {
    constexpr int moment = 2000; // milliseconds
    for (QProcess* process : {&m_submission, &m_question}) {
        process->disconnect(this);
        if (process == &m_submission && process->waitForFinished(moment)) continue;
        if (process->state() == QProcess::NotRunning) continue;
        process->kill();
        process->waitForFinished(moment);
    }
}

bool ClusterQueue::isAvailable() {
    return io::answerSoon([] { return !QStandardPaths::findExecutable(QStringLiteral("sbatch")).isEmpty(); })
        .value_or(false);
}

void ClusterQueue::submit(const QString& folder) {
    emit stateChanged(tr("Submitting…"));
    m_submission.setWorkingDirectory(folder);
    m_submission.start(QStringLiteral("bash"), {QLatin1String(io::submitScript)});
}

void ClusterQueue::takeSubmitted(int exitCode, QProcess::ExitStatus status) {
    static const QRegularExpression jobs(QStringLiteral("squeue -j ([0-9]+)(?:,([0-9]+))?"));
    const auto match = jobs.match(QString::fromLocal8Bit(m_submission.readAllStandardOutput()));
    const QString problem = QString::fromLocal8Bit(m_submission.readAllStandardError()).trimmed();
    if (status != QProcess::NormalExit || exitCode != 0 || !match.hasMatch())
        return fail(problem.isEmpty() ? tr("The script ended without submitting anything.") : problem);
    m_jobs = {match.captured(1)};
    if (!match.captured(2).isEmpty()) m_jobs << match.captured(2);
    m_timer.start();
    ask();
}

void ClusterQueue::ask() {
    if (m_question.state() != QProcess::NotRunning) return; // still running
    m_question.start(QStringLiteral("squeue"),
                     {QStringLiteral("--noheader"), QStringLiteral("--array"), QStringLiteral("--states=all"),
                      QStringLiteral("--jobs=") + m_jobs.join(u','), QStringLiteral("--format=%F %T")});
}

// An answer that fails is asked for again: the controller may be busy, or starting anew.
void ClusterQueue::takeStates(int exitCode) {
    if (exitCode != 0) return;
    QMap<QString, States> jobs;
    for (const QString& line : QString::fromLatin1(m_question.readAllStandardOutput()).split(u'\n')) {
        const QStringList words = line.simplified().split(u' ');
        if (words.size() == 2) ++jobs[words[0]][words[1]];
    }
    const Counts drawing = counted(jobs[m_jobs[0]]);
    if (drawing.all() == 0) return;
    QString text = drawingText(drawing);
    bool isDone = drawing.done == drawing.all();
    bool isOver = drawing.running + drawing.waiting == 0;
    if (m_jobs.size() > 1 && (isDone || !isOver)) { // no video without all frames
        const Counts video = counted(jobs[m_jobs[1]]);
        text += u' ' + videoText(video);
        isDone = video.done > 0;
        isOver = isDone || (isOver && video.failed > 0);
    }
    if (isOver)
        text += u' ' + (isDone ? tr("The result is in %1.") : tr("The reason is in the logs in %1."))
                           .arg(m_submission.workingDirectory());
    emit stateChanged(text);
    if (!isOver) return;
    m_timer.stop();
    emit finished(isDone);
}

void ClusterQueue::fail(const QString& sentence) {
    emit stateChanged(tr("Slurm did not accept the job: %1").arg(sentence));
    emit finished(false);
}

} // namespace view
