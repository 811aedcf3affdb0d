// SPDX-License-Identifier: MIT
#include "panels/entries_edits.h"

#include "document/unique_names.h"
#include "io/flame.h"

#include <QCoreApplication>
#include <QSet>

#include <algorithm>
#include <iterator>
#include <utility>

namespace view {
namespace {

using document::Entry;
using document::EntryId;
using document::FractalFile;

constexpr int longestName = 18; // bytes that Fractint compares, docs/formats.md

QString sentence(const char* text) {
    return QCoreApplication::translate("view::EntriesEdits", text);
}

QByteArray textAbove(const Entry& entry) {
    return entry.source ? entry.source->before : QByteArray();
}

void setTextAbove(Entry& entry, const QByteArray& before) {
    if (!entry.source || entry.source->before == before) return;
    auto source = std::make_shared<document::EntrySource>(*entry.source);
    source->before = before;
    entry.source = std::move(source);
}

// The text above the first entry of `original` goes to what is the first entry now; the two swap when both
// are there.
void keepTextAtTop(FractalFile& file, const FractalFile& original) {
    if (original.entries.isEmpty()) return;
    const Entry& formerFirst = original.entries.front();
    const QByteArray top = textAbove(formerFirst);
    if (top.isEmpty()) return;
    if (file.entries.isEmpty()) {
        file.tail.prepend(top);
        return;
    }
    Entry& first = file.entries.front();
    if (first.id == formerFirst.id || !first.source) return;
    const qsizetype place = document::indexOf(file, formerFirst.id);
    const QByteArray own = textAbove(first);
    setTextAbove(first, place < 0 ? top + own : top);
    if (place >= 0) setTextAbove(file.entries[place], own);
}

QSet<EntryId> setOf(const QList<EntryId>& ids) {
    return {ids.begin(), ids.end()};
}

bool isTaken(const FractalFile& file, EntryId id, const QString& name) {
    return std::any_of(file.entries.begin(), file.entries.end(), [&](const Entry& entry) {
        return entry.id != id && entry.fractal->name.compare(name, Qt::CaseInsensitive) == 0;
    });
}

} // namespace

Inserted inserted(FractalFile file, const QList<Entry>& entries, EntryId after) {
    Inserted result;
    qsizetype place = document::indexOf(file, after) + 1;
    if (place == 0) place = file.entries.size();
    document::UniqueNames names(file.entries.size() + entries.size());
    for (const Entry& entry : std::as_const(file.entries))
        names.take(entry.fractal->name);
    auto id = static_cast<std::uint32_t>(document::freshId(file));
    QList<Entry> all; // copied once, since there may be a hundred thousand
    all.reserve(file.entries.size() + entries.size());
    std::copy_n(file.entries.cbegin(), place, std::back_inserter(all));
    for (Entry entry : entries) {
        entry.id = static_cast<EntryId>(id++);
        if (document::dimension(*entry.fractal) == 0) {
            names.take(entry.fractal->name);
        } else {
            document::Fractal fractal = *entry.fractal;
            fractal.name = names.give(fractal.name);
            entry.fractal = std::make_shared<const document::Fractal>(std::move(fractal));
        }
        result.ids.append(entry.id);
        all.append(std::move(entry));
    }
    std::copy(file.entries.cbegin() + place, file.entries.cend(), std::back_inserter(all));
    file.entries = std::move(all);
    result.file = std::move(file);
    return result;
}

FractalFile removed(FractalFile file, const QList<EntryId>& ids) {
    const FractalFile original = file;
    file.entries.removeIf([gone = setOf(ids)](const Entry& entry) { return gone.contains(entry.id); });
    keepTextAtTop(file, original);
    return file;
}

FractalFile moved(FractalFile file, const QList<EntryId>& ids, EntryId before) {
    const FractalFile original = file;
    const auto isMoving = [moving = setOf(ids)](const Entry& entry) { return moving.contains(entry.id); };
    qsizetype place = document::indexOf(file, before);
    if (place < 0) place = file.entries.size();
    const auto target = file.entries.begin() + place;
    std::stable_partition(file.entries.begin(), target, [&](const Entry& entry) { return !isMoving(entry); });
    std::stable_partition(target, file.entries.end(), isMoving);
    keepTextAtTop(file, original);
    return file;
}

FractalFile replaced(FractalFile file, EntryId id, document::Fractal fractal) {
    if (const qsizetype place = document::indexOf(file, id); place >= 0)
        file.entries[place].fractal = std::make_shared<const document::Fractal>(std::move(fractal));
    return file;
}

FractalFile turnedOver(FractalFile file, const QList<EntryId>& ids) {
    const QSet<EntryId> turned = setOf(ids);
    for (Entry& entry : file.entries) {
        if (!turned.contains(entry.id) || !document::system2(*entry.fractal)) continue;
        document::Fractal fractal = *entry.fractal;
        for (auto& map : document::system2(fractal)->maps)
            map.map = io::flipped(map.map);
        entry.fractal = std::make_shared<const document::Fractal>(std::move(fractal));
    }
    return file;
}

std::optional<QString> nameProblem(const FractalFile& file, EntryId id, const QString& name) {
    if (name.isEmpty()) return sentence(QT_TRANSLATE_NOOP("view::EntriesEdits", "An entry needs a name."));
    for (const QChar c : name) {
        if (c.isSpace())
            return sentence(QT_TRANSLATE_NOOP(
                "view::EntriesEdits", "A name holds no blanks: Fractint would read its first word only."));
        if ((!c.isPrint() && !c.isSurrogate()) || QStringLiteral("(){};:").contains(c))
            return sentence(
                       QT_TRANSLATE_NOOP("view::EntriesEdits",
                                         "“%1” cannot be part of a name, because it has a meaning in .ifs "
                                         "files."))
                .arg(c);
    }
    if (name.toUtf8().size() > longestName)
        return sentence(QT_TRANSLATE_NOOP("view::EntriesEdits",
                                          "A name has at most %1 characters; Fractint ignores the rest."))
            .arg(longestName);
    if (name.compare(QLatin1String("comment"), Qt::CaseInsensitive) == 0)
        return sentence(
                   QT_TRANSLATE_NOOP("view::EntriesEdits",
                                     "Fractint does not list an entry called “%1”; choose another name."))
            .arg(name);
    if (isTaken(file, id, name))
        return sentence(
                   QT_TRANSLATE_NOOP("view::EntriesEdits",
                                     "Another entry is called “%1” (upper and lower case count as equal)."))
            .arg(name);
    return std::nullopt;
}

} // namespace view
