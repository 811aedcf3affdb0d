// SPDX-License-Identifier: MIT
#include "panels/maps_edits.h"

#include <QCoreApplication>

#include <algorithm>
#include <iterator>

namespace view {

namespace {

bool contains(const Rows& rows, int row) {
    return std::ranges::binary_search(rows, row);
}

MapRows rowsOf(const document::System2& system, const Rows& rows) {
    MapRows maps;
    for (const int row : rows)
        maps.push_back(system.maps[static_cast<std::size_t>(row)]);
    return maps;
}

std::vector<ifs::MapId> idsOf(const MapRows& maps) {
    std::vector<ifs::MapId> ids;
    for (const auto& map : maps)
        ids.push_back(map.id);
    return ids;
}

// Inserts under fresh ids, which are returned.
std::vector<ifs::MapId> insert(document::System2& system, std::size_t at, const MapRows& maps) {
    std::vector<ifs::MapId> ids = ifs::freshIds(system, maps.size());
    auto place =
        system.maps.insert(system.maps.begin() + static_cast<std::ptrdiff_t>(at), maps.begin(), maps.end());
    for (const ifs::MapId id : ids)
        place++->id = id;
    return ids;
}

// The mean of the weights given, so that a new map takes part like the others.
std::optional<double> typicalWeight(const document::System2& system) {
    double sum = 0;
    int count = 0;
    for (const auto& map : system.maps) {
        if (!map.weight) return std::nullopt;
        if (*map.weight > 0) {
            sum += *map.weight;
            ++count;
        }
    }
    return count > 0 ? std::optional(sum / count) : std::nullopt;
}

ifs::Vector<2> middleOf(const std::vector<ifs::Vector<2>>& points) {
    ifs::Vector<2> sum = ifs::Vector<2>::Zero();
    for (const auto& point : points)
        sum += point;
    return points.empty() ? sum : ifs::Vector<2>(sum / static_cast<double>(points.size()));
}

std::vector<double> ruleWeights(const document::System2& enabled, WeightRule rule) {
    const auto maps = ifs::mapsOf(enabled);
    switch (rule) {
    case WeightRule::Determinant:
        return ifs::determinantWeights<2>(maps);
    case WeightRule::Equal:
        return ifs::equalWeights(maps.size());
    case WeightRule::Dimension:
        return ifs::dimensionWeights<2>(maps);
    case WeightRule::Normalise:
        break;
    }
    return ifs::probabilities(enabled);
}

} // namespace

MapsEdit withNewMap(document::Fractal fractal) {
    const ifs::Vector<2> middle = middleOf(document::effectiveCage(fractal).rest);
    document::System2& system = *document::system2(fractal);
    ifs::WeightedMap<2> added;
    added.map = ifs::affineMap(0.5, 0, 0, 0.5, middle.x() / 2, middle.y() / 2);
    added.weight = typicalWeight(system);
    auto ids = insert(system, system.maps.size(), {added});
    return {std::move(fractal), std::move(ids)};
}

MapsEdit withDuplicates(document::Fractal fractal, const Rows& rows) {
    if (rows.empty()) return {std::move(fractal), {}};
    document::System2& system = *document::system2(fractal);
    auto ids = insert(system, static_cast<std::size_t>(rows.back()) + 1, rowsOf(system, rows));
    return {std::move(fractal), std::move(ids)};
}

MapsEdit withoutMaps(document::Fractal fractal, const Rows& rows) {
    auto& maps = document::system2(fractal)->maps;
    MapRows kept;
    std::vector<ifs::MapId> gone;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        if (contains(rows, static_cast<int>(i)))
            gone.push_back(maps[i].id);
        else
            kept.push_back(maps[i]);
    }
    maps = std::move(kept);
    std::ranges::sort(gone);
    fractal.appearance.mapColours.eraseIf( // a later map may get the id
        [&](ifs::MapId id) { return std::ranges::binary_search(gone, id); });
    std::vector<ifs::MapId> touched;
    if (!rows.empty() && !maps.empty())
        touched.push_back(maps[std::min(static_cast<std::size_t>(rows.front()), maps.size() - 1)].id);
    return {std::move(fractal), std::move(touched)};
}

MapsEdit withMapsMoved(document::Fractal fractal, const Rows& rows, int before) {
    auto& maps = document::system2(fractal)->maps;
    const MapRows block = rowsOf(*document::system2(fractal), rows);
    MapRows moved;
    for (int row = 0; row <= static_cast<int>(maps.size()); ++row) {
        if (row == before) moved.insert(moved.end(), block.begin(), block.end());
        if (row < static_cast<int>(maps.size()) && !contains(rows, row))
            moved.push_back(maps[static_cast<std::size_t>(row)]);
    }
    maps = std::move(moved);
    return {std::move(fractal), idsOf(block)};
}

MapsEdit withMapsPasted(document::Fractal fractal, const Rows& rows, const MapRows& pasted) {
    document::System2& system = *document::system2(fractal);
    const std::size_t replaced = std::min(rows.size(), pasted.size());
    std::vector<ifs::MapId> ids;
    for (std::size_t i = 0; i < replaced; ++i) {
        auto& map = system.maps[static_cast<std::size_t>(rows[i])];
        const ifs::MapId id = map.id;
        map = pasted[i];
        map.id = id;
        ids.push_back(id);
    }
    if (pasted.size() > replaced) {
        const std::size_t at =
            replaced == 0 ? system.maps.size() : static_cast<std::size_t>(rows[replaced - 1]) + 1;
        const auto added =
            insert(system, at, MapRows(pasted.begin() + static_cast<std::ptrdiff_t>(replaced), pasted.end()));
        ids.insert(ids.end(), added.begin(), added.end());
    } else if (rows.size() > replaced) {
        const Rows surplus(rows.begin() + static_cast<std::ptrdiff_t>(replaced), rows.end());
        return {withoutMaps(std::move(fractal), surplus).fractal, std::move(ids)};
    }
    return {std::move(fractal), std::move(ids)};
}

namespace {

struct Steps {
    Q_DECLARE_TR_FUNCTIONS(view::MapsPanel)
};

std::vector<ifs::MapId> applied(document::Document& document, const QString& text, MapsEdit edit) {
    document.edit(text, std::move(edit.fractal));
    return std::move(edit.touched);
}

} // namespace

std::vector<ifs::MapId> duplicateMaps(document::Document& document, const Rows& rows) {
    return applied(document,
                   rows.size() == 1 ? Steps::tr("Duplicate a map")
                                    : Steps::tr("Duplicate %1 maps").arg(rows.size()),
                   withDuplicates(document.fractal(), rows));
}

std::vector<ifs::MapId> deleteMaps(document::Document& document, const Rows& rows) {
    return applied(
        document, rows.size() == 1 ? Steps::tr("Delete a map") : Steps::tr("Delete %1 maps").arg(rows.size()),
        withoutMaps(document.fractal(), rows));
}

document::Fractal withWeight(document::Fractal fractal, int row, double weight) {
    document::System2& system = *document::system2(fractal);
    document::System2 allOn = system;
    for (auto& map : allOn.maps)
        map.enabled = true;
    const std::vector<double> now = ifs::probabilities(allOn);
    for (std::size_t i = 0; i < system.maps.size(); ++i) {
        if (!system.maps[i].weight) system.maps[i].weight = now[i];
    }
    system.maps[static_cast<std::size_t>(row)].weight = weight;
    return fractal;
}

document::Fractal withWeights(document::Fractal fractal, WeightRule rule) {
    document::System2& system = *document::system2(fractal);
    document::System2 enabled;
    std::copy_if(system.maps.begin(), system.maps.end(), std::back_inserter(enabled.maps),
                 [](const auto& map) { return map.enabled; });
    const std::vector<double> weights = ruleWeights(enabled, rule);
    std::size_t next = 0;
    for (auto& map : system.maps) {
        if (map.enabled) map.weight = weights[next++];
    }
    return fractal;
}

} // namespace view
