// SPDX-License-Identifier: MIT
#include "document/edits/maps/maps_edits.h"

#include "document/edits/maps/map_locks.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "document/text/text.h"
#include "ifs/system/links.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <type_traits>
#include <utility>

namespace document {

namespace {

template <int Dim> using MapsOf = std::vector<ifs::WeightedMap<Dim>>;

bool contains(const Rows& rows, int row) {
    return std::ranges::binary_search(rows, row);
}

// Changes the system, whatever its dimension; returns the maps to select.
template <class Change> MapsEdit edited(Fractal fractal, Change change) {
    std::vector<ifs::MapId> touched;
    if (System2* system = system2(fractal))
        touched = change(*system);
    else if (System3* solid = system3(fractal))
        touched = change(*solid);
    return {std::move(fractal), std::move(touched)};
}

template <int Dim> MapsOf<Dim> rowsOf(const ifs::IteratedFunctionSystem<Dim>& system, const Rows& rows) {
    MapsOf<Dim> maps;
    for (const int row : rows)
        maps.push_back(system.maps[static_cast<std::size_t>(row)]);
    return maps;
}

// Inserts under fresh ids, which are returned.
template <int Dim>
std::vector<ifs::MapId> insert(ifs::IteratedFunctionSystem<Dim>& system, std::size_t at,
                               const MapsOf<Dim>& maps) {
    std::vector<ifs::MapId> ids = ifs::freshIds(system, maps.size());
    auto next =
        system.maps.insert(system.maps.begin() + static_cast<std::ptrdiff_t>(at), maps.begin(), maps.end());
    for (const ifs::MapId id : ids)
        next++->id = id;
    return ids;
}

// The mean of the weights given, so that a new map takes part like the others.
template <int Dim> std::optional<double> typicalWeight(const ifs::IteratedFunctionSystem<Dim>& system) {
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

template <int Dim> ifs::Vector<Dim> middleOf(const std::vector<ifs::Vector<Dim>>& points) {
    ifs::Vector<Dim> sum = ifs::Vector<Dim>::Zero();
    for (const auto& point : points)
        sum += point;
    return points.empty() ? sum : ifs::Vector<Dim>(sum / static_cast<double>(points.size()));
}

template <int Dim>
std::vector<ifs::MapId> addMap(ifs::IteratedFunctionSystem<Dim>& system, const ifs::Vector<Dim>& middle) {
    ifs::WeightedMap<Dim> added;
    added.map = {ifs::Matrix<Dim>::Identity() / 2, middle / 2};
    added.weight = typicalWeight(system);
    return insert(system, system.maps.size(), MapsOf<Dim>{added});
}

template <int Dim>
std::vector<double> ruleWeights(const ifs::IteratedFunctionSystem<Dim>& enabled, WeightRule rule) {
    const auto maps = ifs::mapsOf(enabled);
    switch (rule) {
    case WeightRule::Determinant:
        return ifs::determinantWeights<Dim>(maps);
    case WeightRule::Equal:
        return ifs::equalWeights(maps.size());
    case WeightRule::Dimension:
        return ifs::dimensionWeights<Dim>(maps);
    case WeightRule::Normalise:
        break;
    }
    return ifs::probabilities(enabled);
}

template <int Dim> void setWeight(ifs::IteratedFunctionSystem<Dim>& system, std::size_t row, double weight) {
    ifs::IteratedFunctionSystem<Dim> allOn = system;
    allOn.links.clear();
    for (auto& map : allOn.maps)
        map.enabled = true;
    const std::vector<double> now = ifs::probabilities(allOn);
    for (std::size_t i = 0; i < system.maps.size(); ++i) {
        if (!system.maps[i].weight) system.maps[i].weight = now[i];
    }
    system.maps[row].weight = weight;
}

// Locked maps keep their weights, and the others share the rest.
template <int Dim>
void setWeights(ifs::IteratedFunctionSystem<Dim>& system, WeightRule rule, const MapLabels& labels) {
    ifs::IteratedFunctionSystem<Dim> enabled;
    std::copy_if(system.maps.begin(), system.maps.end(), std::back_inserter(enabled.maps),
                 [](const auto& map) { return map.enabled; });
    std::vector<double> weights = ruleWeights(enabled, rule);
    const std::vector<double> now = ifs::probabilities(enabled);
    double all = 0, kept = 0, shared = 0;
    bool isAnyLocked = false;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const double given = enabled.maps[i].weight.value_or(now[i]);
        const bool isLocked = labels.of(enabled.maps[i].id).isLocked;
        if (isLocked) weights[i] = given;
        isAnyLocked = isAnyLocked || isLocked;
        all += given;
        (isLocked ? kept : shared) += weights[i];
    }
    if (isAnyLocked) {
        const double left = (kept < 1 ? 1 : all) - kept;
        if (!(left > 0) || !(shared > 0)) return; // nothing to share, or no map to share it
        for (std::size_t i = 0; i < weights.size(); ++i)
            if (!labels.of(enabled.maps[i].id).isLocked) weights[i] *= left / shared;
    }
    std::size_t next = 0;
    for (auto& map : system.maps) {
        if (map.enabled) map.weight = weights[next++];
    }
}

// The sum of the weights of maps that are on; none where one has no weight, or none to share by.
template <int Dim> std::optional<double> sumOfWeights(const ifs::IteratedFunctionSystem<Dim>& system) {
    double sum = 0;
    for (const auto& map : system.maps) {
        if (!map.enabled) continue;
        if (!map.weight || !(*map.weight >= 0)) return std::nullopt;
        sum += *map.weight;
    }
    return sum;
}

bool sumsToOne(const Fractal& fractal) {
    const auto isOne = [](std::optional<double> sum) { return sum && std::abs(*sum - 1) <= 1e-6; };
    if (const System2* system = system2(fractal)) return isOne(sumOfWeights(*system));
    if (const System3* solid = system3(fractal)) return isOne(sumOfWeights(*solid));
    return false;
}

template <int Dim> void scaleToOne(ifs::IteratedFunctionSystem<Dim>& system) {
    const std::optional<double> sum = sumOfWeights(system);
    if (sum && *sum > 0 && std::isfinite(*sum)) setWeights(system, WeightRule::Normalise, {});
}

// Scales weights that summed to 1 before so that they do again: the shares of the maps stay in proportion.
MapsEdit keepingSum(bool wasOne, MapsEdit edit) {
    if (!wasOne || sumsToOne(edit.fractal)) return edit;
    if (System2* system = system2(edit.fractal))
        scaleToOne(*system);
    else if (System3* solid = system3(edit.fractal))
        scaleToOne(*solid);
    return edit;
}

} // namespace

MapsEdit withNewMap(Fractal fractal) {
    const bool wasOne = sumsToOne(fractal);
    if (system2(fractal)) {
        const ifs::Vector<2> middle = middleOf<2>(effectiveCage(fractal).rest);
        auto ids = addMap<2>(*system2(fractal), middle);
        return keepingSum(wasOne, {std::move(fractal), std::move(ids)});
    }
    const auto cage = spaceCage(fractal);
    if (!cage) return {std::move(fractal), {}};
    auto ids = addMap<3>(*system3(fractal), middleOf<3>(cage->rest));
    return keepingSum(wasOne, {std::move(fractal), std::move(ids)});
}

MapsEdit withDuplicates(Fractal fractal, const Rows& rows) {
    if (rows.empty()) return {std::move(fractal), {}};
    const bool wasOne = sumsToOne(fractal);
    std::vector<ifs::MapId> ids;
    MapsEdit result = edited(std::move(fractal), [&](auto& system) {
        const auto originals = rowsOf(system, rows);
        auto copies = insert(system, static_cast<std::size_t>(rows.back()) + 1, originals);
        for (const auto& map : originals)
            ids.push_back(map.id);
        ifs::copyLinks(system, ids, copies);
        return copies;
    });
    MapLabels& labels = result.fractal.mapLabels;
    const MapLabels before = labels;
    for (std::size_t i = 0; i < ids.size(); ++i)
        copyLabel(before, ids[i], labels, result.touched[i], CopyLock::Drop);
    return keepingSum(wasOne, std::move(result));
}

MapsEdit withoutMaps(Fractal fractal, const Rows& rows) {
    const bool wasOne = sumsToOne(fractal);
    std::vector<ifs::MapId> gone;
    MapsEdit result = edited(std::move(fractal), [&](auto& system) {
        auto& maps = system.maps;
        std::decay_t<decltype(maps)> kept;
        for (std::size_t i = 0; i < maps.size(); ++i) {
            if (contains(rows, static_cast<int>(i)))
                gone.push_back(maps[i].id);
            else
                kept.push_back(maps[i]);
        }
        maps = std::move(kept);
        ifs::dropStaleLinks(system);
        std::vector<ifs::MapId> touched;
        if (!rows.empty() && !maps.empty())
            touched.push_back(maps[std::min(static_cast<std::size_t>(rows.front()), maps.size() - 1)].id);
        return touched;
    });
    std::ranges::sort(gone);
    const auto isGone = [&](ifs::MapId id) { return std::ranges::binary_search(gone, id); };
    result.fractal.appearance.mapColours.eraseIf(isGone); // a later map may reuse the id
    result.fractal.appearance.mapBlends.eraseIf(isGone);
    result.fractal.mapLabels.eraseIf(isGone);
    return keepingSum(wasOne, std::move(result));
}

MapsEdit withMapsMoved(Fractal fractal, const Rows& rows, int before) {
    return edited(std::move(fractal), [&](auto& system) {
        auto& maps = system.maps;
        const auto block = rowsOf(system, rows);
        std::decay_t<decltype(maps)> moved;
        for (int row = 0; row <= static_cast<int>(maps.size()); ++row) {
            if (row == before) moved.insert(moved.end(), block.begin(), block.end());
            if (row < static_cast<int>(maps.size()) && !contains(rows, row))
                moved.push_back(maps[static_cast<std::size_t>(row)]);
        }
        maps = std::move(moved);
        std::vector<ifs::MapId> ids;
        for (const auto& map : block)
            ids.push_back(map.id);
        return ids;
    });
}

namespace {

template <int Dim> MapsEdit withPasted(Fractal fractal, const Rows& rows, const MapsOf<Dim>& pasted) {
    auto& system = std::get<Shape<Dim>>(fractal.shape).system;
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
        const auto added = insert(
            system, at, MapsOf<Dim>(pasted.begin() + static_cast<std::ptrdiff_t>(replaced), pasted.end()));
        ids.insert(ids.end(), added.begin(), added.end());
    } else if (rows.size() > replaced) {
        const Rows surplus(rows.begin() + static_cast<std::ptrdiff_t>(replaced), rows.end());
        return {withoutMaps(std::move(fractal), surplus).fractal, std::move(ids)};
    }
    return {std::move(fractal), std::move(ids)};
}

} // namespace

MapsEdit withMapsPasted(Fractal fractal, const Rows& rows, const MapRows& pasted) {
    const bool wasOne = sumsToOne(fractal);
    return keepingSum(wasOne, withPasted<2>(std::move(fractal), rows, pasted));
}

MapsEdit withMapsPasted(Fractal fractal, const Rows& rows, const SpaceMapRows& pasted) {
    const bool wasOne = sumsToOne(fractal);
    return keepingSum(wasOne, withPasted<3>(std::move(fractal), rows, pasted));
}

namespace {

std::vector<ifs::MapId> applied(Document& document, const QString& text, MapsEdit edit) {
    document.edit(text, std::move(edit.fractal));
    return std::move(edit.touched);
}

} // namespace

std::vector<ifs::MapId> duplicateMaps(Document& document, const Rows& rows) {
    return applied(document,
                   rows.size() == 1 ? Text::tr("Duplicate a map")
                                    : Text::tr("Duplicate %1 maps").arg(rows.size()),
                   withDuplicates(document.fractal(), rows));
}

std::vector<ifs::MapId> deleteMaps(Document& document, const Rows& rows) {
    if (!lockObstacle(document.fractal(), rows).isEmpty()) return {};
    return applied(document,
                   rows.size() == 1 ? Text::tr("Delete a map") : Text::tr("Delete %1 maps").arg(rows.size()),
                   withoutMaps(document.fractal(), rows));
}

Fractal withWeight(Fractal fractal, int row, double weight) {
    const auto at = static_cast<std::size_t>(row);
    if (System2* system = system2(fractal))
        setWeight(*system, at, weight);
    else if (System3* solid = system3(fractal))
        setWeight(*solid, at, weight);
    return fractal;
}

Fractal withWeights(Fractal fractal, WeightRule rule) {
    if (System2* system = system2(fractal))
        setWeights(*system, rule, fractal.mapLabels);
    else if (System3* solid = system3(fractal))
        setWeights(*solid, rule, fractal.mapLabels);
    return fractal;
}

} // namespace document
