// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"

#include <QObject>
#include <QStringList>

#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace view {

// A state of an entry that the user keeps while working on it.
struct Snapshot {
    quint64 key = 0; // of no other one
    QString name;
    bool isNamed = false;                               // by the user
    std::shared_ptr<const document::Fractal> fractal{}; // of the entry, with its animation; never null
};

// The snapshots of the entries of a document. They last as long as the file is open:
// docs/decisions/0022-snapshots-are-looks-and-views-are-lines.md. Taking, naming and deleting them is no
// step of the history; restoring one is.
class Snapshots : public QObject {
    Q_OBJECT

public:
    explicit Snapshots(document::Document* document, QObject* parent = nullptr);

    const std::vector<Snapshot>& list() const; // of the current entry, in the order in which they were taken
    bool isPossible() const;                   // there is an entry, and it could be read

    void take();               // the present state, unless it is kept already
    void restore(quint64 key); // code, cage, appearance and animation; the entry keeps name and comments
    void rename(quint64 key, const QString& name);
    void remove(quint64 key);
    void bringBack();             // the one that was removed last
    QString removed() const;      // its name; empty when there is none
    void addAsEntry(quint64 key); // behind the current entry, which stays the current one

    // The one that a comparison shows: the one last taken, restored or marked, which the panel does with the
    // one that is selected. When it is removed, the one that takes its place. nullptr without one.
    const Snapshot* marked() const;
    void mark(quint64 key);
    std::optional<quint64> present() const; // the one that the entry is like, but for a gesture that is open
    bool isAsNow(const Snapshot& snapshot) const;
    // Snapshots of all entries, deleted ones too, that are like no entry of the file, each with the name of
    // its own: they are lost when the file is closed.
    QStringList unsaved() const;
    QStringList lostByDiscarding() const; // besides these: they are like entries with unsaved changes

signals:
    void changed(); // in what is listed, or marked, or like the entry
    void taken();
    void message(const QString& sentence);

private:
    struct Strip {
        std::vector<Snapshot> list;
        std::vector<Snapshot> removed; // the last one behind
        quint64 marked = 0;
        int count = 0; // taken so far
    };
    // Snapshots of an entry that is not in the file; it may come back by undo.
    struct Parked {
        document::EntryId id;
        std::shared_ptr<const document::Fractal> fractal;
        Strip strip;
    };

    QStringList likeNone(const QList<document::Entry>& entries) const;
    void follow(const document::Change& change);
    void park();
    void updatePresent();
    Strip& strip() { return m_strips[m_document->currentId()]; }
    const Strip* stripNow() const;
    const Snapshot* find(quint64 key) const;

    document::Document* m_document;
    std::map<document::EntryId, Strip> m_strips;
    std::map<document::EntryId, std::shared_ptr<const document::Fractal>> m_seen; // of entries with a strip
    std::vector<Parked> m_parked;
    QList<document::Entry> m_saved; // the entries as they were opened or saved
    std::optional<quint64> m_present;
    quint64 m_lastKey = 0;
};

} // namespace view
