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

using Flags = std::vector<char>;

auto place(const Link& link) {
    return std::tuple(link.from, link.to);
}

template <int Dim> std::map<MapId, std::size_t> rowsOf(const IteratedFunctionSystem<Dim>& system) {
    std::map<MapId, std::size_t> rows;
    for (std::size_t i = 0; i < system.maps.size(); ++i)
        rows.emplace(system.maps[i].id, i);
    return rows;
}

// Removes states that have no edge to a state that stays, until all have. `edge(i, j)`: from i to j.
template <class Edge> Flags lasting(Flags stays, Edge edge) {
    const std::size_t n = stays.size();
    std::vector<std::size_t> exits(n, 0);
    std::vector<std::size_t> gone;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j)
            exits[i] += stays[i] && stays[j] && edge(i, j) ? 1 : 0;
        if (stays[i] && exits[i] == 0) gone.push_back(i);
    }
    while (!gone.empty()) {
        const std::size_t j = gone.back();
        gone.pop_back();
        stays[j] = 0;
        for (std::size_t i = 0; i < n; ++i)
            if (stays[i] && edge(i, j) && --exits[i] == 0) gone.push_back(i);
    }
    return stays;
}

// Tarjan's algorithm with a stack of its own: a part is complete before those that lead to it.
class PartSearch {
public:
    PartSearch(std::span<const double> matrix, std::size_t size)
        : m_matrix(matrix), m_size(size), m_number(size, 0), m_low(size, 0), m_isOpen(size, 0) {}

    std::vector<std::vector<std::size_t>> parts() {
        for (std::size_t i = 0; i < m_size; ++i)
            if (m_number[i] == 0) walkFrom(i);
        return std::move(m_parts);
    }

private:
    struct Visit {
        std::size_t state;
        std::size_t next; // successor to look at
    };

    void enter(std::size_t state) {
        m_number[state] = m_low[state] = ++m_count;
        m_open.push_back(state);
        m_isOpen[state] = 1;
        m_path.push_back({state, 0});
    }

    void walkFrom(std::size_t start) {
        enter(start);
        while (!m_path.empty()) {
            const auto [state, next] = m_path.back();
            if (next == m_size) {
                leave();
                continue;
            }
            ++m_path.back().next;
            if (!(m_matrix[state * m_size + next] > 0)) continue;
            if (m_number[next] == 0)
                enter(next);
            else if (m_isOpen[next])
                m_low[state] = std::min(m_low[state], m_number[next]);
        }
    }

    void leave() {
        const std::size_t state = m_path.back().state;
        m_path.pop_back();
        if (!m_path.empty()) {
            std::size_t& low = m_low[m_path.back().state];
            low = std::min(low, m_low[state]);
        }
        if (m_low[state] != m_number[state]) return;
        std::vector<std::size_t> part;
        do {
            part.push_back(m_open.back());
            m_isOpen[part.back()] = 0;
            m_open.pop_back();
        } while (part.back() != state);
        std::ranges::sort(part);
        m_parts.push_back(std::move(part));
    }

    std::span<const double> m_matrix;
    std::size_t m_size;
    std::size_t m_count = 0;
    std::vector<std::size_t> m_number, m_low, m_open;
    Flags m_isOpen;
    std::vector<Visit> m_path;
    std::vector<std::vector<std::size_t>> m_parts;
};

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

// Whether every state leads to a state of its part only.
bool isClosed(std::span<const double> matrix, std::size_t size, const std::vector<std::size_t>& part) {
    for (const std::size_t i : part)
        for (std::size_t j = 0; j < size; ++j)
            if (matrix[i * size + j] > 0 && !std::ranges::binary_search(part, j)) return false;
    return true;
}

} // namespace

template <int Dim> std::vector<double> linkMatrix(const IteratedFunctionSystem<Dim>& system) {
    const std::size_t n = system.maps.size();
    std::vector<double> matrix(n * n, 1);
    if (system.links.empty()) return matrix;
    const auto rows = rowsOf(system);
    for (const Link& link : system.links) {
        const auto from = rows.find(link.from), to = rows.find(link.to);
        if (from == rows.end() || to == rows.end()) continue;
        matrix[from->second * n + to->second] =
            link.weight > 0 && std::isfinite(link.weight) ? link.weight : 0;
    }
    return matrix;
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
    if (system.links.empty()) return;
    const auto rows = rowsOf(system);
    std::erase_if(system.links,
                  [&](const Link& link) { return !rows.contains(link.from) || !rows.contains(link.to); });
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
    const std::size_t n = system.maps.size();
    std::vector<LinkState> states(n, LinkState::TakesPart);
    Flags on(n, 1);
    for (std::size_t i = 0; i < n; ++i) {
        if (!isOff(system.maps[i])) continue;
        on[i] = 0;
        states[i] = LinkState::Off;
    }
    if (system.links.empty()) return states;
    std::vector<double> matrix = linkMatrix(system);
    const Flags goesOn = lasting(on, [&](auto i, auto j) { return matrix[i * n + j] > 0; });
    const Flags hasPast = lasting(goesOn, [&](auto i, auto j) { return matrix[j * n + i] > 0; });
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            if (!goesOn[i] || !goesOn[j]) matrix[i * n + j] = 0;
    for (const auto& part : connectedParts(matrix, n)) {
        if (isClosed(matrix, n, part) && goesOn[part.front()]) continue;
        for (const std::size_t i : part)
            if (on[i])
                states[i] = !goesOn[i]    ? LinkState::Ends
                            : !hasPast[i] ? LinkState::Unreached
                                          : LinkState::Left;
    }
    return states;
}

std::vector<std::vector<std::size_t>> connectedParts(std::span<const double> matrix, std::size_t size) {
    return PartSearch(matrix, size).parts();
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
