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
    quint64 key = 0; // unique
    QString name;
    bool isNamed = false;                               // true: named by the user
    std::shared_ptr<const document::Fractal> fractal{}; // entry with its animation; never null
};

// The snapshots of the entries of a document. They last as long as the file is open:
// docs/decisions/0022-snapshots-are-looks-and-views-are-lines.md. Taking, naming and deleting them is no
// step of the history; restoring one is.
class Snapshots : public QObject {
    Q_OBJECT

public:
    explicit Snapshots(document::Document* document, QObject* parent = nullptr);

    const std::vector<Snapshot>& list() const; // snapshots of the current entry, oldest first
    bool isPossible() const;                   // true if there is a readable entry

    void take(); // snapshot of the present state, unless one is kept already
    // Restores code, cage, appearance and animation; the entry keeps name and comments.
    void restore(quint64 key);
    void rename(quint64 key, const QString& name);
    void remove(quint64 key);
    void bringBack();             // restores the snapshot removed last
    QString removed() const;      // name of the snapshot removed last; empty: none
    void addAsEntry(quint64 key); // inserted behind the current entry, which stays current

    // The one that a comparison shows: the one last taken, restored or marked, which the panel does with the
    // one that is selected. When it is removed, the one that takes its place. nullptr without one.
    const Snapshot* marked() const;
    void mark(quint64 key);
    std::optional<quint64> present() const; // snapshot equal to the entry, apart from an open gesture
    bool isAsNow(const Snapshot& snapshot) const;
    // Snapshots of all entries, deleted ones too, that are like no entry of the file, each with the name of
    // its own: they are lost when the file is closed.
    QStringList unsaved() const;
    QStringList lostByDiscarding() const; // further snapshots, equal to entries with unsaved changes

signals:
    void changed(); // sent for the list, the mark, and equality with the entry
    void taken();
    void message(const QString& sentence);

private:
    struct Strip {
        std::vector<Snapshot> list;
        std::vector<Snapshot> removed; // newest last
        quint64 marked = 0;
        int count = 0; // number of snapshots taken
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
    // Last known states of entries with a strip.
    std::map<document::EntryId, std::shared_ptr<const document::Fractal>> m_seen;
    std::vector<Parked> m_parked;
    QList<document::Entry> m_saved; // entries as opened or saved
    std::optional<quint64> m_present;
    quint64 m_lastKey = 0;
};

} // namespace view
