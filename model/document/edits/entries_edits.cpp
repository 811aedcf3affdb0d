// SPDX-License-Identifier: MIT
#include "document/edits/entries_edits.h"

#include "document/text/text.h"
#include "document/text/unique_names.h"

#include <QSet>

#include <algorithm>
#include <iterator>
#include <utility>

namespace document {
namespace {

constexpr int maxName = 18; // bytes that Fractint compares, docs/formats.md

QByteArray textAbove(const Entry& entry) {
    return entry.source ? entry.source->before : QByteArray();
}

void setTextAbove(Entry& entry, const QByteArray& before) {
    if (!entry.source || entry.source->before == before) return;
    auto source = std::make_shared<EntrySource>(*entry.source);
    source->before = before;
    entry.source = std::move(source);
}

// The text above the first entry of `original` goes to the entry that is first now; the two swap when both
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
    const qsizetype index = indexOf(file, formerFirst.id);
    const QByteArray own = textAbove(first);
    setTextAbove(first, index < 0 ? top + own : top);
    if (index >= 0) setTextAbove(file.entries[index], own);
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
    qsizetype index = indexOf(file, after) + 1;
    if (index == 0) index = file.entries.size();
    UniqueNames names(file.entries.size() + entries.size());
    for (const Entry& entry : std::as_const(file.entries))
        names.take(entry.fractal->name);
    auto id = static_cast<std::uint32_t>(freshId(file));
    QList<Entry> all; // single copy, since there may be a hundred thousand
    all.reserve(file.entries.size() + entries.size());
    std::copy_n(file.entries.cbegin(), index, std::back_inserter(all));
    for (Entry entry : entries) {
        entry.id = static_cast<EntryId>(id++);
        if (dimension(*entry.fractal) == 0) {
            names.take(entry.fractal->name);
        } else {
            Fractal fractal = *entry.fractal;
            fractal.name = names.give(fractal.name);
            entry.fractal = std::make_shared<const Fractal>(std::move(fractal));
        }
        result.ids.append(entry.id);
        all.append(std::move(entry));
    }
    std::copy(file.entries.cbegin() + index, file.entries.cend(), std::back_inserter(all));
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
    qsizetype index = indexOf(file, before);
    if (index < 0) index = file.entries.size();
    const auto target = file.entries.begin() + index;
    std::stable_partition(file.entries.begin(), target, [&](const Entry& entry) { return !isMoving(entry); });
    std::stable_partition(target, file.entries.end(), isMoving);
    keepTextAtTop(file, original);
    return file;
}

FractalFile replaced(FractalFile file, EntryId id, Fractal fractal) {
    if (const qsizetype index = indexOf(file, id); index >= 0)
        file.entries[index].fractal = std::make_shared<const Fractal>(std::move(fractal));
    return file;
}

FractalFile turnedOver(FractalFile file, const QList<EntryId>& ids) {
    const QSet<EntryId> turned = setOf(ids);
    for (Entry& entry : file.entries) {
        if (!turned.contains(entry.id) || !system2(*entry.fractal)) continue;
        Fractal fractal = *entry.fractal;
        for (auto& map : system2(fractal)->maps)
            map.map = ifs::flipped(map.map);
        system2(fractal)->symmetry = ifs::flipped(system2(fractal)->symmetry);
        entry.fractal = std::make_shared<const Fractal>(std::move(fractal));
    }
    return file;
}

std::optional<QString> nameProblem(const FractalFile& file, EntryId id, const QString& name) {
    if (name.isEmpty()) return Text::tr("An entry needs a name.");
    for (const QChar c : name) {
        if (c.isSpace()) return Text::tr("Names cannot contain spaces: Fractint reads only the first word.");
        if ((!c.isPrint() && !c.isSurrogate()) || QStringLiteral("(){};:").contains(c))
            return Text::tr("“%1” cannot be part of a name, because it has a meaning in .ifs "
                            "files.")
                .arg(c);
    }
    if (name.toUtf8().size() > maxName)
        return Text::tr("A name can have at most %1 characters; Fractint ignores the rest.").arg(maxName);
    if (name.compare(QLatin1String("comment"), Qt::CaseInsensitive) == 0)
        return Text::tr("Fractint does not list an entry called “%1”; choose another name.").arg(name);
    if (isTaken(file, id, name))
        return Text::tr("Another entry is called “%1” (upper and lower case are not distinguished).")
            .arg(name);
    return std::nullopt;
}

} // namespace document
