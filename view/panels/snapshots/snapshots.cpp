// SPDX-License-Identifier: MIT
#include "panels/snapshots/snapshots.h"

#include "document/edits/entries_edits.h"

#include <algorithm>
#include <iterator>

namespace view {

namespace {

using document::Fractal;

// The restored entry: it stays the same entry, with the name and comments that the user has given it.
Fractal restored(const Fractal& kept, const Fractal& now) {
    Fractal fractal = kept;
    fractal.name = now.name;
    fractal.headerComment = now.headerComment;
    fractal.comments = now.comments;
    return fractal;
}

auto withKey(quint64 key) {
    return [key](const Snapshot& snapshot) { return snapshot.key == key; };
}

} // namespace

Snapshots::Snapshots(document::Document* document, QObject* parent)
    : QObject(parent), m_document(document), m_saved(document->file().entries) {
    connect(document, &document::Document::changed, this, &Snapshots::follow);
    connect(document->undoStack(), &QUndoStack::cleanChanged, this, [this](bool isClean) {
        if (isClean) m_saved = m_document->file().entries;
    });
}

const Snapshots::Strip* Snapshots::stripNow() const {
    const auto found = m_strips.find(m_document->currentId());
    return found == m_strips.end() ? nullptr : &found->second;
}

const std::vector<Snapshot>& Snapshots::list() const {
    static const std::vector<Snapshot> none;
    const Strip* strip = stripNow();
    return strip ? strip->list : none;
}

const Snapshot* Snapshots::find(quint64 key) const {
    const auto found = std::ranges::find_if(list(), withKey(key));
    return found == list().end() ? nullptr : &*found;
}

bool Snapshots::isPossible() const {
    return document::dimension(m_document->entryFractal()) != 0;
}

bool Snapshots::isAsNow(const Snapshot& snapshot) const {
    const auto& now = m_document->currentEntry().fractal;
    if (snapshot.fractal == now) return true;
    return document::isSameSystem(*snapshot.fractal, *now) && restored(*snapshot.fractal, *now) == *now;
}

QStringList Snapshots::likeNone(const QList<document::Entry>& entries) const {
    const auto isKept = [&entries](const Fractal& fractal) {
        return std::ranges::any_of(entries, [&fractal](const document::Entry& entry) {
            return document::isSameSystem(fractal, *entry.fractal) &&
                   restored(fractal, *entry.fractal) == *entry.fractal;
        });
    };
    QStringList names;
    const auto add = [&](const Strip& strip, const Fractal& entry) {
        for (const Snapshot& snapshot : strip.list)
            if (!isKept(*snapshot.fractal))
                names << tr("%1 of “%2”", "snapshot, entry").arg(snapshot.name, entry.name);
    };
    for (const document::Entry& entry : m_document->file().entries)
        if (const auto strip = m_strips.find(entry.id); strip != m_strips.end())
            add(strip->second, *entry.fractal);
    for (const Parked& parked : m_parked)
        add(parked.strip, *parked.fractal);
    return names;
}

QStringList Snapshots::unsaved() const {
    return likeNone(m_document->file().entries);
}

QStringList Snapshots::lostByDiscarding() const {
    QStringList names = likeNone(m_saved);
    for (const QString& name : unsaved())
        names.removeOne(name);
    return names;
}

void Snapshots::take() {
    if (!isPossible()) return emit message(tr("An entry that could not be read has no snapshots."));
    const auto same = std::ranges::find_if(list(), [this](const Snapshot& one) { return isAsNow(one); });
    if (same != list().end()) {
        const QString name = same->name;
        mark(same->key);
        return emit message(tr("“%1” is the same as the fractal.").arg(name));
    }
    Strip& strip = this->strip();
    const auto& now = m_document->currentEntry().fractal;
    strip.list.push_back({++m_lastKey, tr("Snapshot %1").arg(++strip.count), false, now});
    strip.marked = m_lastKey;
    m_seen[m_document->currentId()] = now;
    updatePresent();
    emit changed();
    emit taken();
}

void Snapshots::restore(quint64 key) {
    const Snapshot* snapshot = find(key);
    if (!snapshot) return;
    const Snapshot wanted = *snapshot;
    mark(key);
    m_document->editEntry(tr("Restore “%1”").arg(wanted.name),
                          restored(*wanted.fractal, m_document->entryFractal()));
}

void Snapshots::rename(quint64 key, const QString& name) {
    const Snapshot* snapshot = find(key);
    const QString wanted = name.simplified();
    if (!snapshot || wanted.isEmpty() || wanted == snapshot->name) return;
    auto& one = *std::ranges::find_if(strip().list, withKey(key));
    one.name = wanted;
    one.isNamed = true;
    emit changed();
}

void Snapshots::remove(quint64 key) {
    if (!find(key)) return;
    Strip& strip = this->strip();
    const auto found = std::ranges::find_if(strip.list, withKey(key));
    strip.removed.push_back(*found);
    const auto next = strip.list.erase(found);
    if (strip.marked == key && next != strip.list.end())
        strip.marked = next->key;
    else if (strip.marked == key)
        strip.marked = strip.list.empty() ? 0 : strip.list.back().key;
    updatePresent();
    emit changed();
    emit message(tr("“%1” was deleted. To bring it back, use the menu of the panel.").arg(removed()));
}

QString Snapshots::removed() const {
    const Strip* strip = stripNow();
    return strip && !strip->removed.empty() ? strip->removed.back().name : QString();
}

// Among the others in the order in which they were taken.
void Snapshots::bringBack() {
    if (removed().isEmpty()) return;
    Strip& strip = this->strip();
    Snapshot back = std::move(strip.removed.back());
    strip.removed.pop_back();
    strip.marked = back.key;
    const auto behind =
        std::ranges::find_if(strip.list, [&](const Snapshot& snapshot) { return snapshot.key > back.key; });
    strip.list.insert(behind, std::move(back));
    updatePresent();
    emit changed();
}

void Snapshots::addAsEntry(quint64 key) {
    const Snapshot* snapshot = find(key);
    if (!snapshot) return;
    document::Entry entry;
    Fractal fractal = *snapshot->fractal;
    fractal.name = snapshot->isNamed ? snapshot->name : m_document->entryFractal().name;
    const QString text = tr("Add “%1” as an entry").arg(snapshot->name);
    entry.fractal = std::make_shared<const Fractal>(std::move(fractal));
    const document::EntryId current = m_document->currentId();
    const document::Inserted inserted = document::inserted(m_document->file(), {entry}, current);
    const QString name =
        inserted.file.entries.at(document::indexOf(inserted.file, inserted.ids.front())).fractal->name;
    m_document->editFile(text, inserted.file, current);
    emit message(tr("Added to the file as the entry “%1”.").arg(name));
}

const Snapshot* Snapshots::marked() const {
    const Strip* strip = stripNow();
    return strip ? find(strip->marked) : nullptr;
}

void Snapshots::mark(quint64 key) {
    if (!find(key) || strip().marked == key) return;
    strip().marked = key;
    emit changed();
}

std::optional<quint64> Snapshots::present() const {
    return m_present;
}

void Snapshots::updatePresent() {
    m_present.reset();
    if (!isPossible()) return;
    for (const Snapshot& snapshot : list())
        if (isAsNow(snapshot) && (!m_present || marked() == &snapshot)) m_present = snapshot.key;
}

void Snapshots::follow(const document::Change& change) {
    using document::Change;
    if (change.parts & Change::File) {
        m_strips.clear();
        m_seen.clear();
        m_parked.clear();
        m_saved = m_document->file().entries;
    } else if (change.parts & Change::Entries) {
        park();
    }
    const auto current = m_seen.find(m_document->currentId());
    if (current != m_seen.end() && !change.live) current->second = m_document->currentEntry().fractal;
    if (change.live || change.parts == Change::Parts(Change::Time)) return;
    updatePresent();
    emit changed();
}

// Ids of entries that have gone may be given to new ones.
void Snapshots::park() {
    const document::FractalFile& file = m_document->file();
    for (auto strip = m_strips.begin(); strip != m_strips.end();) {
        const bool isHere = document::indexOf(file, strip->first) >= 0;
        if (!isHere)
            m_parked.push_back(
                {strip->first, std::exchange(m_seen[strip->first], nullptr), std::move(strip->second)});
        strip = isHere ? std::next(strip) : m_strips.erase(strip);
    }
    std::erase_if(m_parked, [&](Parked& parked) {
        const qsizetype index = document::indexOf(file, parked.id);
        const bool isBack = index >= 0 && file.entries.at(index).fractal == parked.fractal;
        if (isBack) {
            m_seen[parked.id] = parked.fractal;
            m_strips[parked.id] = std::move(parked.strip);
        }
        return isBack;
    });
}

} // namespace view
