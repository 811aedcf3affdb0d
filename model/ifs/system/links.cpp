// SPDX-License-Identifier: MIT
#include "ifs/system/links.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace ifs {

namespace {

auto place(const Link& link) {
    return std::tuple(link.from, link.to);
}

// π of one closed part by the algorithm of Grassmann, Taksar and Heyman, which never subtracts. Sum 1.
std::vector<double> stationaryOf(const std::vector<double>& forward, std::size_t size,
                                 const std::vector<std::size_t>& part) {
    const std::size_t n = part.size();
    std::vector<double> a(n * n);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            a[i * n + j] = forward[part[i] * size + part[j]];
    for (std::size_t k = n; k-- > 1;) {
        double out = 0;
        for (std::size_t j = 0; j < k; ++j)
            out += a[k * n + j];
        for (std::size_t i = 0; i < k; ++i) {
            a[i * n + k] /= out;
            for (std::size_t j = 0; j < k; ++j)
                a[i * n + j] += a[i * n + k] * a[k * n + j];
        }
    }
    std::vector<double> result(n, 1);
    for (std::size_t k = 1; k < n; ++k) {
        result[k] = 0;
        for (std::size_t i = 0; i < k; ++i)
            result[k] += result[i] * a[i * n + k];
    }
    return shares(std::move(result));
}

} // namespace

template <int Dim> std::vector<double> linkMatrix(const IteratedFunctionSystem<Dim>& system) {
    return matrixOf(system.maps, system.links);
}

template <int Dim> void setLink(IteratedFunctionSystem<Dim>& system, Link link) {
    auto& links = system.links;
    const auto at = std::ranges::lower_bound(links, place(link), {}, place);
    const bool isKnown = at != links.end() && place(*at) == place(link);
    if (link.weight == 1) {
        if (isKnown) links.erase(at);
    } else if (isKnown) {
        *at = link;
    } else {
        links.insert(at, link);
    }
}

template <int Dim> void setLinks(IteratedFunctionSystem<Dim>& system, std::span<const double> matrix) {
    const std::size_t n = system.maps.size();
    system.links.clear();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            if (matrix[i * n + j] != 1)
                system.links.push_back({system.maps[i].id, system.maps[j].id, matrix[i * n + j]});
    std::ranges::sort(system.links, {}, place);
}

template <int Dim>
void copyLinks(IteratedFunctionSystem<Dim>& system, std::span<const MapId> originals,
               std::span<const MapId> copies) {
    std::multimap<MapId, MapId> copiesOf;
    for (std::size_t k = 0; k < originals.size(); ++k)
        copiesOf.emplace(originals[k], copies[k]);
    std::vector<Link> links = system.links;
    const auto withCopies = [&](MapId id) {
        std::vector<MapId> ids{id};
        const auto [begin, end] = copiesOf.equal_range(id);
        for (auto copy = begin; copy != end; ++copy)
            ids.push_back(copy->second);
        return ids;
    };
    for (const Link& link : system.links)
        for (const MapId from : withCopies(link.from))
            for (const MapId to : withCopies(link.to))
                if (from != link.from || to != link.to) links.push_back({from, to, link.weight});
    std::ranges::sort(links, {}, place);
    system.links = std::move(links);
}

template <int Dim> void dropStaleLinks(IteratedFunctionSystem<Dim>& system) {
    std::map<MapId, MapId> same;
    for (const auto& map : system.maps)
        same.emplace(map.id, map.id);
    if (!system.links.empty()) renumberLinks(system, same);
}

template <int Dim>
void renumberLinks(IteratedFunctionSystem<Dim>& system, const std::map<MapId, MapId>& ids) {
    std::erase_if(system.links,
                  [&](const Link& link) { return !ids.contains(link.from) || !ids.contains(link.to); });
    for (Link& link : system.links)
        link = {ids.at(link.from), ids.at(link.to), link.weight};
    std::ranges::sort(system.links, {}, place);
}

template <int Dim> std::vector<LinkState> linkStates(const IteratedFunctionSystem<Dim>& system) {
    std::vector<char> on;
    for (const auto& map : system.maps)
        on.push_back(isOff(map) ? 0 : 1);
    return statesOf(linkMatrix(system), on);
}

template <int Dim> Transitions transitions(const ActiveMaps<Dim>& active) {
    const std::size_t n = active.maps.size();
    Transitions result;
    result.size = n;
    result.forward.resize(n * n);
    result.backward.resize(n * n);
    result.stationary = active.probabilities;
    for (std::size_t i = 0; i < n; ++i) {
        std::vector<double> row = active.probabilities;
        for (std::size_t j = 0; j < n && active.isLinked(); ++j)
            row[j] *= active.links[i * n + j];
        row = shares(std::move(row));
        std::ranges::copy(row, result.forward.begin() + std::ptrdiff_t(i * n));
    }
    result.closed = connectedParts(result.forward, n);
    if (active.isLinked())
        for (const auto& part : result.closed) {
            double weight = 0;
            for (const std::size_t i : part)
                weight += active.probabilities[i];
            const auto inside = stationaryOf(result.forward, n, part);
            for (std::size_t k = 0; k < part.size(); ++k)
                result.stationary[part[k]] = weight * inside[k];
        }
    for (std::size_t j = 0; j < n; ++j) {
        std::vector<double> column(n);
        for (std::size_t i = 0; i < n; ++i)
            column[i] = result.stationary[i] * result.forward[i * n + j];
        column = shares(std::move(column));
        std::ranges::copy(column, result.backward.begin() + std::ptrdiff_t(j * n));
    }
    return result;
}

#define BARYCAGE_INSTANTIATE(Dim)                                                                            \
    template std::vector<double> linkMatrix(const IteratedFunctionSystem<Dim>&);                             \
    template void setLink(IteratedFunctionSystem<Dim>&, Link);                                               \
    template void setLinks(IteratedFunctionSystem<Dim>&, std::span<const double>);                           \
    template void copyLinks(IteratedFunctionSystem<Dim>&, std::span<const MapId>, std::span<const MapId>);   \
    template void renumberLinks(IteratedFunctionSystem<Dim>&, const std::map<MapId, MapId>&);                \
    template void dropStaleLinks(IteratedFunctionSystem<Dim>&);                                              \
    template std::vector<LinkState> linkStates(const IteratedFunctionSystem<Dim>&);                          \
    template Transitions transitions(const ActiveMaps<Dim>&);
BARYCAGE_INSTANTIATE(2)
BARYCAGE_INSTANTIATE(3)
#undef BARYCAGE_INSTANTIATE

} // namespace ifs
