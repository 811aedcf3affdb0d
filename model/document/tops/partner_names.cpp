// SPDX-License-Identifier: MIT
#include "document/tops/partner_names.h"

#include "document/tops/kept_theft.h"

#include <QDir>
#include <QHash>

#include <optional>
#include <utility>

namespace document {

namespace {

using Names = QHash<QString, QString>; // old names in lower case → new names

// The fractal where its partner has another name now; nullopt where there is nothing to change.
std::optional<Fractal> withPartnerOf(const Fractal& fractal, const Names& names) {
    auto theft = keptTheft(fractal);
    if (!theft) return std::nullopt;
    const auto now = names.constFind(theft->partner.toLower());
    if (now == names.cend() || *now == theft->partner) return std::nullopt;
    theft->partner = *now;
    return withTheft(fractal, theft);
}

} // namespace

FractalFile renamed(const FractalFile& file, EntryId id, const QString& name) {
    const qsizetype index = indexOf(file, id);
    if (index < 0) return file;
    Fractal fractal = *file.entries[index].fractal;
    const Names names{{fractal.name.toLower(), name}};
    fractal.name = name;
    FractalFile result = replaced(file, id, std::move(fractal));
    for (const Entry& entry : file.entries)
        if (entry.id != id)
            if (auto changed = withPartnerOf(*entry.fractal, names))
                result = replaced(std::move(result), entry.id, *std::move(changed));
    return result;
}

Inserted insertedTogether(FractalFile file, const QList<Entry>& entries, EntryId after) {
    Inserted result = inserted(std::move(file), entries, after);
    if (result.ids.isEmpty()) return result;
    const qsizetype first = indexOf(result.file, result.ids.first());
    Names names;
    for (qsizetype k = 0; k < entries.size(); ++k)
        names.insert(entries[k].fractal->name.toLower(), result.file.entries[first + k].fractal->name);
    for (qsizetype k = 0; k < entries.size(); ++k)
        if (auto changed = withPartnerOf(*result.file.entries[first + k].fractal, names))
            result.file = replaced(std::move(result.file), result.ids[k], *std::move(changed));
    return result;
}

Fractal withPictureFrom(Fractal fractal, const QString& folder) {
    auto theft = keptTheft(fractal);
    if (!theft || theft->picture.isEmpty() || folder.isEmpty()) return fractal;
    theft->picture = QDir::cleanPath(QDir(folder).filePath(theft->picture));
    return withTheft(std::move(fractal), theft);
}

} // namespace document
