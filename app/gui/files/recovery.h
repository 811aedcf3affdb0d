// SPDX-License-Identifier: MIT
#pragma once

#include "document/background/listener.h"
#include "document/background/work_in_order.h"
#include "document/disk/journal.h"
#include "files/open_file.h"

#include <QList>
#include <QObject>
#include <QTimer>

#include <chrono>
#include <memory>
#include <optional>

namespace view {
class LessonNotebook;
}

// Keeps a window's unsaved work in a journal, at most two seconds behind, until it is saved or given up. When
// the disk is too slow for that, or full, or the file too large, it says so.
class Recovery : public QObject {
    Q_OBJECT

public:
    Recovery(document::Document* document, const OpenFile* file, QObject* parent);

    ~Recovery() override; // lets pending writes finish later, if the disk answers

    // Adds the unsaved steps of the lesson, which must outlive this object.
    void follow(const view::LessonNotebook* lesson);

    // The document now holds this work of another process, which is forgotten once it is kept here, saved or
    // discarded.
    void takeOver(const document::Abandoned& abandoned);
    void giveUp(); // for a window that closes with its work saved or discarded
    void store();  // writes unsaved work at once
    void letGo();  // for the end of the program; leaves what is stored to the next run

    static QString folder();
    // Asks about the work of processes that ended without closing; returns the work that the user wants back.
    // Unwanted work is deleted. Damaged journals are reported once, with their places.
    static QList<document::Abandoned> ask();
    static QStringList lines(const QList<document::Snapshot>& snapshots); // rows of the list in ask()

signals:
    void cannotKeep(const QString& sentence); // sent once per series of failures
    // True if work has been unsaved for two seconds and is not yet in the journal.
    void lateChanged(bool isLate);

private:
    using Time = std::chrono::steady_clock::time_point;
    static constexpr Time never = Time::max();

    bool isModified() const;
    void noteChange();
    void keepSoon();
    // Does not wait for another change; writes in a background thread, since disks may be slow.
    void keepNow();
    void discard();
    void finish(bool kept); // ends the oldest snapshot being written
    void report(bool kept);
    void watch();
    static void reportDamaged(QStringList paths);

    document::Document* m_document;
    const OpenFile* m_file;
    const view::LessonNotebook* m_lesson = nullptr;
    std::shared_ptr<document::Journal> m_journal; // accessed only by the writing thread
    std::shared_ptr<document::Listener> m_listener = std::make_shared<document::Listener>();
    document::WorkInOrder m_writer;
    QTimer m_timer;
    bool m_kept = true;         // result of the last write
    bool m_wasModified = false; // state after the previous change
    Time m_oldest = never;      // time of the oldest change that is in no snapshot
    QList<Time> m_writing;      // m_oldest of each snapshot being written
    bool m_isAgain = false;     // true if another snapshot is to follow
    QTimer m_watch;             // fires when the oldest change becomes late
    bool m_isLate = false;
    bool m_isGivenUp = false;
    std::optional<document::Abandoned> m_takenOver;
    std::chrono::milliseconds m_lastTook{0};
};
