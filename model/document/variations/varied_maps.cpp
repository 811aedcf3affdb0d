// SPDX-License-Identifier: MIT
#include "document/variations/varied_maps.h"

#include "ifs/system/links.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace document {

namespace {

constexpr double maxNorm = 0.95;
constexpr std::size_t maxAdded = 12; // number of maps from which on none is added
constexpr double floorOfWeights = 0.02;

template <int Dim> using System = ifs::IteratedFunctionSystem<Dim>;

// The size of the system: how far its maps shift, so that moves are in proportion.
template <int Dim> double extentOf(const System<Dim>& system) {
    if (system.maps.empty()) return 1;
    ifs::Vector<Dim> low = system.maps.front().map.translation, high = low;
    for (const auto& map : system.maps) {
        low = low.cwiseMin(map.map.translation);
        high = high.cwiseMax(map.map.translation);
    }
    const double extent = (high - low).norm();
    return extent > 0 && std::isfinite(extent) ? extent : 1;
}

template <int Dim> ifs::AffineMap<Dim> newMap(double extent, Chance& chance) {
    ifs::Vector<Dim> stretch;
    stretch[0] = chance.between(0.35, 0.8);
    for (Eigen::Index i = 1; i < Dim; ++i)
        stretch[i] = stretch[0] * chance.between(0.3, 1);
    if (chance.comes(0.2)) stretch[Dim - 1] = -stretch[Dim - 1];
    const ifs::Matrix<Dim> outer = chance.anyRotation<Dim>();
    const ifs::Matrix<Dim> inner = chance.anyRotation<Dim>();
    return {outer * stretch.asDiagonal() * inner, extent * chance.vector<Dim>()};
}

template <int Dim>
void varyMap(ifs::AffineMap<Dim>& map, double strength, double extent, bool tames, Chance& chance) {
    const double norm = ifs::spectralNorm<Dim>(map.linear);
    ifs::Vector<Dim> stretch, shift;
    for (Eigen::Index i = 0; i < Dim; ++i) {
        stretch[i] = std::exp(0.35 * strength * chance.normal());
        shift[i] = 0.25 * strength * extent * chance.normal();
    }
    map.linear = chance.rotation<Dim>(0.9 * strength * chance.normal()) * stretch.asDiagonal() * map.linear;
    map.linear(0, 1) += 0.15 * strength * chance.normal();
    map.translation += shift;
    const double most = tames ? maxNorm : std::max(maxNorm, norm);
    const double now = ifs::spectralNorm<Dim>(map.linear);
    if (now > most) map.linear *= most / now;
}

template <int Dim> double typicalWeight(const System<Dim>& system) {
    double sum = 0;
    int count = 0;
    for (const auto& map : system.maps)
        if (map.enabled && map.weight.value_or(0) > 0) {
            sum += *map.weight;
            ++count;
        }
    return count > 0 ? sum / count : 1;
}

template <int Dim> bool hasWeights(const System<Dim>& system) {
    return std::ranges::all_of(system.maps, [](const auto& map) { return !map.enabled || map.weight; });
}

template <int Dim> void remove(Fractal& fractal, System<Dim>& system, std::size_t index) {
    const ifs::MapId gone = system.maps[index].id;
    system.maps.erase(system.maps.begin() + std::ptrdiff_t(index));
    ifs::dropStaleLinks(system);
    const auto isGone = [gone](ifs::MapId id) { return id == gone; }; // a later map may reuse the id
    fractal.appearance.mapColours.eraseIf(isGone);
    fractal.appearance.mapBlends.eraseIf(isGone);
    fractal.mapLabels.eraseIf(isGone);
}

template <int Dim>
void varyMapsIn(Fractal& fractal, System<Dim>& system, const MapVariation& variation, Chance& chance) {
    const double extent = extentOf(system);
    const auto stays = [&](const ifs::WeightedMap<Dim>& map) {
        return ifs::isOff(map) || fractal.mapLabels.of(map.id).isLocked;
    };
    for (auto& map : system.maps)
        if (!stays(map)) varyMap<Dim>(map.map, variation.strength, extent, variation.tames, chance);
    if (!variation.maySplit) return;
    const double share = 0.35 * variation.strength;
    if (chance.comes(share) && system.maps.size() > 2) {
        const std::size_t index = chance.below(system.maps.size());
        if (!stays(system.maps[index])) remove(fractal, system, index);
    }
    if (!chance.comes(share) || system.maps.size() >= maxAdded) return;
    const ifs::AffineMap<Dim> added = newMap<Dim>(extent, chance);
    std::optional<double> weight;
    if (hasWeights(system)) weight = typicalWeight(system);
    ifs::append(system, added, weight);
}

template <int Dim> struct MapWeights {
    double weight = 0; // present weight
    double rule = 0;   // weight by determinants
};

// Weights of the maps that take part.
template <int Dim> std::map<ifs::MapId, MapWeights<Dim>> weightsOf(const System<Dim>& system) {
    std::vector<ifs::AffineMap<Dim>> maps;
    std::vector<std::size_t> listed;
    for (std::size_t i = 0; i < system.maps.size(); ++i) {
        if (ifs::isOff(system.maps[i])) continue;
        maps.push_back(system.maps[i].map);
        listed.push_back(i);
    }
    const std::vector<double> now = ifs::probabilities(system);
    const std::vector<double> rule = ifs::determinantWeights<Dim>(maps, floorOfWeights);
    std::map<ifs::MapId, MapWeights<Dim>> result;
    for (std::size_t k = 0; k < listed.size(); ++k)
        result[system.maps[listed[k]].id] = {now[listed[k]], rule[k]};
    return result;
}

template <int Dim>
void varyWeightsIn(const Fractal& fractal, System<Dim>& system, const System<Dim>& before, double strength,
                   Chance& chance) {
    const auto was = weightsOf(before), is = weightsOf(system);
    const bool hadWeights = hasWeights(before);
    double sum = 0, drawn = 0; // sums over the maps that change
    std::vector<std::pair<std::size_t, double>> weights;
    double all = hadWeights ? 0 : 1;
    for (const auto& map : before.maps)
        if (hadWeights && !ifs::isOff(map)) all += map.weight.value_or(0);
    for (std::size_t i = 0; i < system.maps.size(); ++i) {
        auto& map = system.maps[i];
        const auto now = is.find(map.id);
        if (now == is.end()) continue;
        const bool isLocked = fractal.mapLabels.of(map.id).isLocked;
        if (isLocked && map.weight) {
            sum += *map.weight;
            continue;
        }
        const auto then = was.find(map.id);
        const double base =
            then == was.end() ? now->second.rule : then->second.weight * now->second.rule / then->second.rule;
        weights.emplace_back(i, base * std::exp((isLocked ? 0 : 1.2) * strength * chance.normal()));
        drawn += weights.back().second;
    }
    const double left = all - sum;
    if (!(left > 0) || !(drawn > 0) || !std::isfinite(drawn)) return;
    for (const auto& [index, weight] : weights)
        system.maps[index].weight = weight * left / drawn;
}

} // namespace

void varyMaps(Fractal& fractal, const MapVariation& variation, Chance& chance) {
    if (System2* system = system2(fractal))
        varyMapsIn<2>(fractal, *system, variation, chance);
    else if (System3* solid = system3(fractal))
        varyMapsIn<3>(fractal, *solid, variation, chance);
}

void varyWeights(Fractal& fractal, const Fractal& before, double strength, Chance& chance) {
    if (System2* system = system2(fractal))
        varyWeightsIn<2>(fractal, *system, *system2(before), strength, chance);
    else if (System3* solid = system3(fractal))
        varyWeightsIn<3>(fractal, *solid, *system3(before), strength, chance);
}

} // namespace document
