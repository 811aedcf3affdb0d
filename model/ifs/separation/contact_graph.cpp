// SPDX-License-Identifier: MIT
#include "ifs/separation/contact_graph.h"
#include "ifs/linear/rounding.h"

#include <algorithm>
#include <bitset>
#include <limits>

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

// Vertices that can all be reached from one another, by the transitive closure.
std::vector<std::vector<std::size_t>> ContactGraph::strongParts() const {
    const std::size_t count = m_edges.size();
    std::vector<std::bitset<maxVertices>> reached(count);
    for (std::size_t k = 0; k < count; ++k)
        for (const Edge& edge : m_edges[k])
            reached[k].set(edge.to);
    for (std::size_t via = 0; via < count; ++via)
        for (std::size_t k = 0; k < count; ++k)
            if (reached[k][via]) reached[k] |= reached[via];
    std::vector<std::vector<std::size_t>> parts;
    std::vector<char> isPlaced(count, 0);
    for (std::size_t k = 0; k < count; ++k) {
        if (isPlaced[k] || !reached[k][k]) continue;
        std::vector<std::size_t> part;
        for (std::size_t other = k; other < count; ++other)
            if (reached[k][other] && reached[other][k]) part.push_back(other);
        for (const std::size_t member : part)
            isPlaced[member] = 1;
        parts.push_back(std::move(part));
    }
    return parts;
}

// Adding the identity keeps the iteration from going round and round.
std::optional<ContactGraph::Radius> ContactGraph::radiusOf(const std::vector<std::size_t>& part) const {
    constexpr int maxRounds = 20'000;
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
    if (m_edges.size() > maxVertices) return std::nullopt;
    Radius result;
    for (const auto& part : strongParts()) {
        const auto radius = radiusOf(part);
        if (!radius) return std::nullopt;
        result = {std::max(result.least, radius->least), std::max(result.most, radius->most)};
    }
    return result;
}

} // namespace ifs
