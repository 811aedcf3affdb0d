// SPDX-License-Identifier: MIT
#pragma once

#include "document/journal.h"
#include "open_file.h"

#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include <chrono>
#include <functional>

// Keeps a window's unsaved work in a journal, at most two seconds behind if the disk is fast enough, until it
// is saved or given up.
class Recovery : public QObject {
    Q_OBJECT

public:
    Recovery(document::Document* document, const OpenFile* file, QObject* parent);

    ~Recovery() override; // when all is written

    // Without waiting for the next change; then(false) when nothing new could be written. Disks may be slow:
    // another thread writes.
    void keepNow(std::function<void(bool)> then = {});
    void discard(); // the window closes and its work is saved or not wanted

    static QString folder();
    // Asks about the work of processes that ended without closing; returns what the user wants back.
    // What is not wanted is forgotten. Journals that are damaged are said to be so, once, and where they are.
    static QList<document::Abandoned> ask();

signals:
    void cannotKeep(const QString& sentence); // once, until it is possible again

private:
    void keepSoon();
    void report(bool kept);
    static void reportDamaged();

    document::Document* m_document;
    const OpenFile* m_file;
    document::Journal m_journal; // used by the thread alone
    QThreadPool m_writer;        // of one thread, so that all happens in its order
    QTimer m_timer;
    bool m_kept = true; // the last time
    int m_writing = 0;  // snapshots on their way to the disk
    bool m_isLate = false;
    std::chrono::milliseconds m_lastTook{0};
};
