// SPDX-License-Identifier: MIT
#include "document/edits/maps/map_locks.h"

#include "document/maps/map_names.h"
#include "document/text/text.h"

#include <algorithm>
#include <utility>

namespace document {

namespace {

constexpr qsizetype maxNamed = 6; // names in a sentence

template <class Use> auto withMaps(const Fractal& fractal, Use use) {
    if (const System2* system = system2(fractal)) return use(system->maps);
    if (const System3* solid = system3(fractal)) return use(solid->maps);
    return use(System2{}.maps);
}

QString sentence(const QStringList& titles) {
    if (titles.isEmpty()) return {};
    if (titles.size() == 1)
        return Text::tr("Map %1 is locked. Unlock it in the Maps panel first.").arg(titles.front());
    return Text::tr("Maps %1 are locked. Unlock them in the Maps panel first.")
        .arg(titles.size() > maxNamed
                 ? titles.first(maxNamed).join(QStringLiteral(", ")) + QStringLiteral(", …")
                 : titles.join(QStringLiteral(", ")));
}

template <class Indices> QString obstacle(const Fractal& fractal, const Indices& indices) {
    if (fractal.mapLabels.isEmpty()) return {};
    QStringList titles;
    for (const auto index : indices) {
        if (isLocked(fractal, std::size_t(index))) titles << mapTitle(fractal, std::size_t(index));
        if (titles.size() > maxNamed) break;
    }
    return sentence(titles);
}

} // namespace

bool isLocked(const Fractal& fractal, std::size_t index) {
    if (fractal.mapLabels.isEmpty()) return false;
    return withMaps(fractal, [&](const auto& maps) {
        return index < maps.size() && fractal.mapLabels.of(maps[index].id).isLocked;
    });
}

QString lockObstacle(const Fractal& fractal, std::span<const std::size_t> indices) {
    return obstacle(fractal, indices);
}

QString lockObstacle(const Fractal& fractal, const std::vector<int>& rows) {
    return obstacle(fractal, rows);
}

std::vector<ifs::MapId> lockedMaps(const Fractal& fractal) {
    std::vector<ifs::MapId> locked;
    if (fractal.mapLabels.isEmpty()) return locked;
    withMaps(fractal, [&](const auto& maps) {
        for (const auto& map : maps)
            if (fractal.mapLabels.of(map.id).isLocked) locked.push_back(map.id);
        return 0;
    });
    return locked;
}

void lockMaps(Document& document, std::span<const ifs::MapId> maps, bool lock) {
    Fractal fractal = document.fractal();
    for (const ifs::MapId id : maps) {
        MapLabel label = fractal.mapLabels.of(id);
        label.isLocked = lock;
        fractal.mapLabels.set(id, std::move(label));
    }
    const auto count = int(maps.size());
    if (count == 1)
        document.edit(lock ? Text::tr("Lock a map") : Text::tr("Unlock a map"), std::move(fractal));
    else
        document.edit((lock ? Text::tr("Lock %1 maps") : Text::tr("Unlock %1 maps")).arg(count),
                      std::move(fractal));
}

void renameMap(Document& document, std::size_t index, const QString& name) {
    Fractal fractal = document.fractal();
    const ifs::MapId id = withMaps(
        fractal, [&](const auto& maps) { return index < maps.size() ? maps[index].id : ifs::MapId::None; });
    if (id == ifs::MapId::None) return;
    MapLabel label = fractal.mapLabels.of(id);
    label.name = mapNameOf(name);
    const QString text = label.name.isEmpty()
                             ? Text::tr("Remove the name of map %1").arg(index + 1)
                             : Text::tr("Name map %1 “%2”").arg(QString::number(index + 1), label.name);
    fractal.mapLabels.set(id, std::move(label));
    document.edit(text, std::move(fractal));
}

void copyLabel(const MapLabels& from, ifs::MapId of, MapLabels& to, ifs::MapId made, CopyLock lock) {
    if (from.isEmpty()) return;
    MapLabel label = from.of(of);
    label.isLocked = label.isLocked && lock == CopyLock::Keep;
    to.set(made, std::move(label));
}

} // namespace document
