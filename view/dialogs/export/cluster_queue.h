// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QProcess>
#include <QStringList>
#include <QTimer>

namespace view {

// Jobs of a Slurm that were submitted from here, as Slurm reports them. They go on when this goes.
class ClusterQueue : public QObject {
    Q_OBJECT

public:
    explicit ClusterQueue(QObject* parent = nullptr);
    ~ClusterQueue() override;

    // Returns true if `sbatch` is found, as far as the drives it may lie on answer at once.
    static bool isAvailable();

    // Runs the script of a job folder, and asks for the state of its jobs from then on.
    void submit(const QString& folder);

signals:
    void stateChanged(const QString& sentence); // state in Slurm, or reason why nothing could be submitted
    void finished(bool isDone);                 // false: some part failed or could not be submitted

private:
    void takeSubmitted(int exitCode, QProcess::ExitStatus status);
    void ask();
    void takeStates(int exitCode);
    void fail(const QString& sentence);

    QProcess m_submission;
    QProcess m_question;
    QTimer m_timer;
    QStringList m_jobs; // jobs of the tasks, and of the video if there is one
};

} // namespace view
