// SPDX-License-Identifier: MIT
#include "document/tops/theft_starters.h"

#include "document/edits/entries_edits.h"
#include "document/tops/divided_words.h"
#include "ifs/tops/families.h"

#include <memory>
#include <vector>

namespace document {

namespace {

Entry entryOf(const QString& name, const std::vector<ifs::AffineMap<2>>& maps) {
    System2 system;
    for (const ifs::AffineMap<2>& map : maps)
        ifs::append(system, map);
    Fractal fractal;
    fractal.name = name;
    fractal.shape = Shape<2>{std::move(system)};
    Entry entry;
    entry.fractal = std::make_shared<const Fractal>(std::move(fractal));
    return entry;
}

std::size_t activeMaps(const Entry& entry) {
    const System2* system = system2(*entry.fractal);
    return system ? ifs::countActive(*system) : 0;
}

} // namespace

StartedTheft withStarter(const FractalFile& file, TheftFamily family) {
    const bool isTriangle = family == TheftFamily::Triangle;
    const Entry from = isTriangle ? entryOf(QStringLiteral("triangle"), ifs::triangleFamily({0.5, 0.5, 0.5}))
                                  : entryOf(QStringLiteral("square"), ifs::squareFamily({0.5, 0.5}));
    const Entry to = isTriangle
                         ? entryOf(QStringLiteral("triangle-moved"), ifs::triangleFamily({0.65, 0.3, 0.4}))
                         : entryOf(QStringLiteral("square-moved"), ifs::squareFamily({0.35, 0.6}));
    Inserted added = inserted(file, {from, to}, EntryId::None);
    const auto fractalOf = [&](EntryId id) { return added.file.entries[indexOf(added.file, id)].fractal; };
    KeptTheft theft;
    theft.partner = fractalOf(added.ids.last())->name;
    theft.mode = TheftMode::TransformPicture;
    theft.pattern = attractor::Pattern::Sunset;
    Fractal kept = withTheft(*fractalOf(added.ids.first()), theft);
    return {replaced(std::move(added.file), added.ids.first(), std::move(kept)), added.ids.first()};
}

EntryId likelyPartner(const FractalFile& file, EntryId of) {
    const qsizetype index = indexOf(file, of);
    if (index < 0) return EntryId::None;
    const std::size_t maps = activeMaps(file.entries[index]);
    EntryId any = EntryId::None;
    for (const Entry& entry : file.entries) {
        if (entry.id == of || activeMaps(entry) == 0) continue;
        if (activeMaps(entry) == maps) return entry.id;
        if (any == EntryId::None) any = entry.id;
    }
    return any;
}

EntryId entryNamed(const FractalFile& file, const QString& name) {
    for (const Entry& entry : file.entries)
        if (entry.fractal->name.compare(name, Qt::CaseInsensitive) == 0) return entry.id;
    return EntryId::None;
}

FractalFile withWordsDivided(const FractalFile& file, EntryId from, EntryId to) {
    const qsizetype first = indexOf(file, from), second = indexOf(file, to);
    if (first < 0 || second < 0) return file;
    const auto count = commonMapCount(activeMaps(file.entries[first]), activeMaps(file.entries[second]));
    if (!count) return file;
    const auto divided = [&](qsizetype index) {
        return withWordsDivided(*file.entries[index].fractal, *count);
    };
    return replaced(replaced(file, from, divided(first)), to, divided(second));
}

} // namespace document
