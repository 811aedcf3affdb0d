// SPDX-License-Identifier: MIT
#include "ifs/system/iterated_function_system.h"

#include "ifs/system/link_graph.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <unordered_set>
#include <utility>

namespace ifs {

namespace {

constexpr double maxConditionNumber = 1e6;

// The part of the matrix that belongs to active maps; empty where any may follow any as its weight says.
template <int Dim>
std::vector<double> activeLinks(const IteratedFunctionSystem<Dim>& system,
                                const std::vector<std::size_t>& index) {
    const std::vector<double> matrix = matrixOf(system.maps, system.links);
    std::vector<double> result;
    bool isEven = true;
    for (const std::size_t i : index)
        for (const std::size_t j : index) {
            result.push_back(matrix[i * system.maps.size() + j]);
            isEven = isEven && result.back() == matrix[i * system.maps.size() + index.front()];
        }
    return isEven ? std::vector<double>{} : result;
}

} // namespace

template <int Dim> bool isOff(const WeightedMap<Dim>& map) {
    return !map.enabled || (map.weight && !(*map.weight > 0 && std::isfinite(*map.weight)));
}

namespace {

template <int Dim> std::vector<LinkState> linkedStates(const IteratedFunctionSystem<Dim>& system) {
    std::vector<char> on;
    for (const auto& map : system.maps)
        on.push_back(isOff(map) ? 0 : 1);
    return statesOf(matrixOf(system.maps, system.links), on);
}

// The listed maps that are not off, whatever the symmetry.
template <int Dim> ActiveMaps<Dim> activeListed(const IteratedFunctionSystem<Dim>& system) {
    ActiveMaps<Dim> active;
    std::vector<double> weights;
    active.maps.reserve(system.maps.size());
    active.index.reserve(system.maps.size());
    weights.reserve(system.maps.size());
    const bool isLinked = !system.links.empty();
    const std::vector<LinkState> states = isLinked ? linkedStates(system) : std::vector<LinkState>{};
    for (std::size_t i = 0; i < system.maps.size(); ++i) {
        const auto& map = system.maps[i];
        if (isLinked ? states[i] != LinkState::TakesPart : isOff(map)) continue;
        active.maps.push_back(map.map);
        active.index.push_back(i);
        if (map.weight) weights.push_back(*map.weight);
    }
    const bool everyWeightGiven = weights.size() == active.maps.size();
    active.probabilities =
        everyWeightGiven ? shares(std::move(weights)) : determinantWeights<Dim>(active.maps);
    // Positive minimum: beside a weight of 3e38, the share of 1e-300 would be 0, although the map takes part.
    for (double& probability : active.probabilities)
        probability = std::max(probability, std::numeric_limits<double>::min());
    if (isLinked) active.links = activeLinks(system, active.index);
    return active;
}

} // namespace

std::vector<double> shares(std::vector<double> masses, double floor) {
    for (double& mass : masses)
        if (!(mass > 0 && std::isfinite(mass))) mass = 0;
    const double largest = masses.empty() ? 0 : std::ranges::max(masses);
    if (largest == 0) return equalWeights(masses.size());
    // Power of two, because a sum of finite masses may overflow, and this scaling is exact.
    const int exponent = std::ilogb(largest);
    for (double& mass : masses)
        mass = std::ldexp(mass, -exponent);
    const auto normalise = [&masses] {
        // Rounds a sum that is almost a power of two: .7, .2 and .1 stay as they are.
        double sum = std::accumulate(masses.begin(), masses.end(), 0.0);
        const double power = std::ldexp(1, int(std::lround(std::log2(sum))));
        if (std::abs(sum - power) <= 0x1p-53 * power * double(masses.size())) sum = power;
        for (double& mass : masses)
            mass /= sum;
    };
    normalise();
    if (floor > 0) {
        for (double& mass : masses)
            mass = std::max(mass, floor);
        normalise();
    }
    return masses;
}

template <int Dim> std::vector<MapId> freshIds(const IteratedFunctionSystem<Dim>& system, std::size_t count) {
    std::uint32_t largest = 0;
    for (const auto& map : system.maps)
        largest = std::max(largest, std::uint32_t(map.id));
    for (const Link& link : system.links) // includes links of deleted maps
        largest = std::max({largest, std::uint32_t(link.from), std::uint32_t(link.to)});
    std::vector<MapId> ids;
    if (count <= std::numeric_limits<std::uint32_t>::max() - largest) {
        while (ids.size() < count)
            ids.push_back(MapId{++largest});
        return ids;
    }
    std::unordered_set<std::uint32_t> taken;
    for (const auto& map : system.maps)
        taken.insert(std::uint32_t(map.id));
    for (const Link& link : system.links)
        taken.insert({std::uint32_t(link.from), std::uint32_t(link.to)});
    for (std::uint32_t id = 1; ids.size() < count; ++id)
        if (!taken.contains(id)) ids.push_back(MapId{id});
    return ids;
}

template <int Dim> MapId freshId(const IteratedFunctionSystem<Dim>& system) {
    return freshIds(system, 1).front();
}

template <int Dim>
MapId append(IteratedFunctionSystem<Dim>& system, const AffineMap<Dim>& map, std::optional<double> weight) {
    const MapId id = freshId(system);
    system.maps.push_back({.id = id, .map = map, .weight = weight});
    return id;
}

template <int Dim> std::vector<AffineMap<Dim>> mapsOf(const IteratedFunctionSystem<Dim>& system) {
    std::vector<AffineMap<Dim>> maps;
    maps.reserve(system.maps.size());
    for (const auto& map : system.maps)
        maps.push_back(map.map);
    return maps;
}

template <int Dim> std::vector<double> probabilities(const IteratedFunctionSystem<Dim>& system) {
    std::vector<double> result(system.maps.size());
    const ActiveMaps<Dim> active = activeListed(system);
    for (std::size_t k = 0; k < active.index.size(); ++k)
        result[active.index[k]] = active.probabilities[k];
    return result;
}

template <int Dim> std::size_t copiesOfEachMap(const IteratedFunctionSystem<Dim>& system) {
    const std::size_t order = groupOrder(system.symmetry.group, system.symmetry.order);
    const std::size_t most = system.links.empty() ? maxSymmetricMaps : maxSymmetricLinkedMaps;
    return system.maps.size() <= most / order ? order : 1;
}

template <int Dim> std::size_t countActive(const IteratedFunctionSystem<Dim>& system) {
    const std::size_t listed =
        system.links.empty()
            ? system.maps.size() - std::size_t(std::ranges::count_if(system.maps, isOff<Dim>))
            : std::size_t(std::ranges::count(linkedStates(system), LinkState::TakesPart));
    return listed * copiesOfEachMap(system);
}

namespace {

// Links of a system whose maps are each followed by their copies.
template <int Dim>
std::vector<Link> linksOfCopies(const IteratedFunctionSystem<Dim>& system,
                                const std::vector<WeightedMap<Dim>>& expanded, std::size_t copies) {
    std::map<MapId, std::size_t> first;
    for (std::size_t i = 0; i < system.maps.size(); ++i)
        first.emplace(system.maps[i].id, i * copies);
    std::vector<Link> links;
    for (const Link& link : system.links) {
        const auto from = first.find(link.from), to = first.find(link.to);
        if (from == first.end() || to == first.end()) continue;
        for (std::size_t k = 0; k < copies; ++k)
            for (std::size_t l = 0; l < copies; ++l)
                links.push_back({expanded[from->second + k].id, expanded[to->second + l].id, link.weight});
    }
    std::ranges::sort(links, {}, [](const Link& link) { return std::pair(link.from, link.to); });
    return links;
}

} // namespace

template <int Dim> IteratedFunctionSystem<Dim> expanded(const IteratedFunctionSystem<Dim>& system) {
    const std::size_t copies = copiesOfEachMap(system);
    IteratedFunctionSystem<Dim> result;
    result.links = system.links;
    if (copies == 1) {
        result.maps = system.maps;
        return result;
    }
    const std::vector<double> given = probabilities(system);
    const bool isRuled = std::ranges::any_of(
        system.maps, [](const WeightedMap<Dim>& map) { return !isOff(map) && !map.weight; });
    const std::vector<MapId> ids = freshIds(system, system.maps.size() * (copies - 1));
    const std::vector<AffineMap<Dim>> group = elements(system.symmetry);
    result.maps.reserve(system.maps.size() * copies);
    auto id = ids.begin();
    for (std::size_t i = 0; i < system.maps.size(); ++i) {
        WeightedMap<Dim> copy = system.maps[i];
        if (isRuled && !isOff(copy)) copy.weight = given[i];
        if (copy.weight) *copy.weight /= double(copies);
        result.maps.push_back(copy);
        for (std::size_t k = 1; k < copies; ++k) {
            copy.id = *id++;
            copy.map = group[k] * system.maps[i].map;
            result.maps.push_back(copy);
        }
    }
    result.links = linksOfCopies(system, result.maps, copies);
    return result;
}

template <int Dim> ActiveMaps<Dim> activeMaps(const IteratedFunctionSystem<Dim>& system) {
    const std::size_t copies = copiesOfEachMap(system);
    if (copies == 1) return activeListed(system);
    ActiveMaps<Dim> active = activeListed(expanded(system));
    for (std::size_t& index : active.index)
        index /= copies;
    return active;
}

template <int Dim>
std::vector<double> determinantWeights(std::span<const AffineMap<Dim>> maps, double floor) {
    std::vector<double> masses;
    masses.reserve(maps.size());
    for (const auto& map : maps)
        masses.push_back(std::abs(determinant<Dim>(map.linear)));
    return shares(std::move(masses), floor);
}

std::vector<double> equalWeights(std::size_t count) {
    return std::vector<double>(count, count == 0 ? 0 : 1.0 / double(count));
}

template <int Dim>
std::optional<IteratedFunctionSystem<Dim>> conjugate(const AffineMap<Dim>& transformation,
                                                     const IteratedFunctionSystem<Dim>& system) {
    const Vector<Dim> stretch = singularValues<Dim>(transformation.linear);
    if (!(stretch[Dim - 1] * maxConditionNumber >= stretch[0])) return std::nullopt;
    IteratedFunctionSystem<Dim> result = system;
    for (auto& map : result.maps) {
        const auto conjugated = conjugate(transformation, map.map);
        if (!conjugated) return std::nullopt;
        map.map = *conjugated;
    }
    result.symmetry = conjugate(transformation, system.symmetry);
    return result;
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template bool isOff(const WeightedMap<Dim>&);                                                            \
    template std::vector<MapId> freshIds(const IteratedFunctionSystem<Dim>&, std::size_t);                   \
    template MapId freshId(const IteratedFunctionSystem<Dim>&);                                              \
    template MapId append(IteratedFunctionSystem<Dim>&, const AffineMap<Dim>&, std::optional<double>);       \
    template std::vector<AffineMap<Dim>> mapsOf(const IteratedFunctionSystem<Dim>&);                         \
    template std::vector<double> probabilities(const IteratedFunctionSystem<Dim>&);                          \
    template std::size_t countActive(const IteratedFunctionSystem<Dim>&);                                    \
    template std::size_t copiesOfEachMap(const IteratedFunctionSystem<Dim>&);                                \
    template IteratedFunctionSystem<Dim> expanded(const IteratedFunctionSystem<Dim>&);                       \
    template ActiveMaps<Dim> activeMaps(const IteratedFunctionSystem<Dim>&);                                 \
    template std::vector<double> determinantWeights(std::span<const AffineMap<Dim>>, double);                \
    template std::optional<IteratedFunctionSystem<Dim>> conjugate(const AffineMap<Dim>&,                     \
                                                                  const IteratedFunctionSystem<Dim>&);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace ifs
