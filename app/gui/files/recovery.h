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

    ~Recovery() override; // what is not written yet is so later, if the disk answers

    void follow(const view::LessonNotebook* lesson); // its unsaved steps, too. It lives longer

    // The document now holds this work of another process, which is forgotten once it is kept here, saved or
    // discarded.
    void takeOver(const document::Abandoned& abandoned);
    void giveUp(); // the window closes, and its work is saved or not wanted
    void store();  // unsaved work, at once
    void letGo();  // the program ends: what is stored belongs to whoever comes next

    static QString folder();
    // Asks about the work of processes that ended without closing; returns the work that the user wants back.
    // Unwanted work is deleted. Damaged journals are reported once, with their places.
    static QList<document::Abandoned> ask();
    static QStringList lines(const QList<document::Snapshot>& snapshots); // as it lists them

signals:
    void cannotKeep(const QString& sentence); // once, until it is possible again
    void lateChanged(bool isLate);            // work is unsaved for two seconds and not in the journal yet

private:
    using Time = std::chrono::steady_clock::time_point;
    static constexpr Time never = Time::max();

    bool isModified() const;
    void noteChange();
    void keepSoon();
    void keepNow(); // without waiting for the next change. Disks may be slow: another thread writes
    void discard();
    void finish(bool kept); // the first of those that are being written
    void report(bool kept);
    void watch();
    static void reportDamaged(QStringList paths);

    document::Document* m_document;
    const OpenFile* m_file;
    const view::LessonNotebook* m_lesson = nullptr;
    std::shared_ptr<document::Journal> m_journal; // used by the thread alone
    std::shared_ptr<document::Listener> m_listener = std::make_shared<document::Listener>();
    document::WorkInOrder m_writer;
    QTimer m_timer;
    bool m_kept = true;         // the last time
    bool m_wasModified = false; // after the change before
    Time m_oldest = never;      // change that is in no snapshot
    QList<Time> m_writing;      // the same of each snapshot on its way to the disk
    bool m_isAgain = false;     // another is to follow
    QTimer m_watch;             // for the moment at which the oldest change is late
    bool m_isLate = false;
    bool m_isGivenUp = false;
    std::optional<document::Abandoned> m_takenOver;
    std::chrono::milliseconds m_lastTook{0};
};
