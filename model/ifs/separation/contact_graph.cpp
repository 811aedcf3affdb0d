// SPDX-License-Identifier: MIT
#include "ifs/separation/contact_graph.h"
#include "ifs/linear/rounding.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace ifs {

std::vector<std::size_t> ContactGraph::prune() {
    const std::size_t count = m_edges.size();
    std::vector<char> isKept(count, 1);
    for (bool isChanged = true; isChanged;) {
        isChanged = false;
        for (std::size_t k = 0; k < count; ++k) {
            if (!isKept[k] ||
                std::ranges::any_of(m_edges[k], [&](const Edge& edge) { return isKept[edge.to] != 0; }))
                continue;
            isKept[k] = 0;
            isChanged = true;
        }
    }
    std::vector<std::size_t> index(count), kept;
    for (std::size_t k = 0; k < count; ++k)
        if (isKept[k]) {
            index[k] = kept.size();
            kept.push_back(k);
        }
    std::vector<std::vector<Edge>> edges(kept.size());
    for (const std::size_t k : kept)
        for (const Edge& edge : m_edges[k])
            if (isKept[edge.to]) edges[index[k]].push_back({index[edge.to], edge.weight});
    m_edges = std::move(edges);
    return kept;
}

// Tarjan's search for sets of vertices that can all be reached from one another, without recursion. Leaves
// out single vertices without an edge to themselves.
std::vector<std::vector<std::size_t>> ContactGraph::strongParts() const {
    constexpr std::size_t unseen = ~std::size_t{0};
    const std::size_t count = m_edges.size();
    struct Visit {
        std::size_t vertex, next; // next edge to follow
    };
    std::vector<std::size_t> order(count, unseen), least(count), open;
    std::vector<char> isOpen(count, 0);
    std::vector<std::vector<std::size_t>> parts;
    std::size_t seen = 0;
    for (std::size_t root = 0; root < count; ++root) {
        if (order[root] != unseen) continue;
        for (std::vector<Visit> way{{root, 0}}; !way.empty();) {
            auto& [k, next] = way.back();
            if (order[k] == unseen) {
                order[k] = least[k] = seen++;
                open.push_back(k);
                isOpen[k] = 1;
            }
            if (next < m_edges[k].size()) {
                const std::size_t to = m_edges[k][next].to;
                if (order[to] == unseen) {
                    way.push_back({to, 0});
                    continue;
                }
                if (isOpen[to]) least[k] = std::min(least[k], least[to]);
                ++next;
                continue;
            }
            if (least[k] == order[k]) close(k, open, isOpen, parts);
            way.pop_back();
        }
    }
    return parts;
}

void ContactGraph::close(std::size_t first, std::vector<std::size_t>& open, std::vector<char>& isOpen,
                         std::vector<std::vector<std::size_t>>& parts) const {
    const auto begin = std::find(open.rbegin(), open.rend(), first).base() - 1;
    std::vector<std::size_t> part(begin, open.end());
    open.erase(begin, open.end());
    for (const std::size_t k : part)
        isOpen[k] = 0;
    const auto isLoop = [first](const Edge& edge) { return edge.to == first; };
    if (part.size() == 1 && std::ranges::none_of(m_edges[first], isLoop)) return;
    std::ranges::sort(part);
    parts.push_back(std::move(part));
}

// Adding the identity keeps the iteration from going round and round.
std::optional<ContactGraph::Radius> ContactGraph::radiusOf(const std::vector<std::size_t>& part) const {
    constexpr std::size_t maxWork = 400'000'000; // edges followed
    std::size_t edges = part.size();
    for (const std::size_t k : part)
        edges += m_edges[k].size();
    const int maxRounds = int(std::min<std::size_t>(20'000, maxWork / edges));
    constexpr double tight = 1e-11, tightest = 1e-14;
    std::optional<Radius> best;
    int last = maxRounds; // limit of refinement, at most as long as the search so far
    std::vector<std::size_t> index(m_edges.size(), part.size());
    for (std::size_t k = 0; k < part.size(); ++k)
        index[part[k]] = k;
    std::vector<double> f(part.size(), 1), next(part.size());
    for (int round = 0; round < last; ++round) {
        Radius radius{std::numeric_limits<double>::infinity(), 0};
        for (std::size_t k = 0; k < part.size(); ++k) {
            next[k] = 0;
            for (const auto& [to, weight] : m_edges[part[k]])
                if (index[to] < part.size()) next[k] += weight * f[index[to]];
            const double rounding = roundingUnit * double(m_edges[part[k]].size() + 6);
            radius.least = std::min(radius.least, next[k] / f[k] * (1 - rounding));
            radius.most = std::max(radius.most, next[k] / f[k] * (1 + rounding));
        }
        const double width = radius.most - radius.least;
        if (width <= tight * radius.most) {
            if (!best) last = std::min(maxRounds, 2 * round + 1);
            if (!best || width < best->most - best->least) best = radius;
        }
        if (width <= tightest * radius.most) return best;
        double largest = 0;
        for (std::size_t k = 0; k < part.size(); ++k)
            largest = std::max(largest, next[k] += f[k]);
        for (std::size_t k = 0; k < part.size(); ++k)
            f[k] = next[k] / largest;
    }
    return best;
}

std::optional<ContactGraph::Radius> ContactGraph::spectralRadius() const {
    Radius result;
    for (const auto& part : strongParts()) {
        const auto radius = radiusOf(part);
        if (!radius) return std::nullopt;
        result = {std::max(result.least, radius->least), std::max(result.most, radius->most)};
    }
    return result;
}

} // namespace ifs
