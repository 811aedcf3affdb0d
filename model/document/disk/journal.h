// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QList>
#include <QString>
#include <QStringList>

#include <memory>
#include <optional>

namespace document {

class ProcessLock;

// Everything needed to offer a window's unsaved work again.
struct Snapshot {
    QString path;         // path of the original file; empty if it was never saved
    QString title;        // title of the window
    int current = 0;      // index of the entry that was shown
    QDateTime when;       // time in UTC
    QByteArray bytes;     // whole file as saving would have written it
    QByteArray base;      // digest of the file at `path` when it was opened or saved
    QByteArray lesson{};  // lesson as saving would have written it; empty if it has no unsaved steps
    QString lessonPath{}; // empty if it was never saved

    friend bool operator==(const Snapshot&, const Snapshot&) = default;
};

// Conversion to and from the bytes of a recovery file; nullopt for bytes that are none, or damaged.
QByteArray recoveryFile(const Snapshot& snapshot);
std::optional<Snapshot> snapshotIn(const QByteArray& recoveryFile);

// The recovery file of one window: rewritten as a whole and atomically, readable by the owner alone, locked
// while its process lives, so that after a crash the next start can tell it from those of running windows.
class Journal {
public:
    // Creates nothing yet, since that may take time. Journals in one folder never share a file.
    explicit Journal(const QString& folder);
    ~Journal(); // keeps the file, if any: only discard() removes it

    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    // Creates the folder when it is missing. False: not written, the one before is kept.
    bool write(const Snapshot& snapshot);
    void discard();
    void letGo(); // releases the lock: the file belongs to the next run

private:
    QString m_path;
    std::unique_ptr<ProcessLock> m_lock;
};

// Snapshots whose process is gone, newest first. They stay until taken away with forget(), and are nobody
// else's while one of these lives: two starts at the same moment do not offer the same work.
struct Abandoned {
    QString journal; // path of the journal's file
    Snapshot snapshot;
    std::shared_ptr<ProcessLock> lock;
};
// Also removes the locks and partly written files of killed processes.
QList<Abandoned> abandonedSnapshots(const QString& folder);
void forget(const Abandoned& abandoned);
// Renames journals whose process is gone and which hold no snapshot any more, so that they are not found
// again; returns their new paths.
QStringList setDamagedAside(const QString& folder);

} // namespace document
