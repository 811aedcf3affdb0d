// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <vector>

// The graph of linked maps by their positions in the list. docs/mathematics.md, "Linked maps".
namespace ifs {

// Role of a map in the chaos game.
enum class LinkState {
    TakesPart, // applied again and again
    Off,       // weight 0
    Ends,      // end of the chaos game: no infinite sequence of maps may follow
    Unreached, // unreachable from the maps that are reached
    Left,      // left by the chaos game for ever
};

// States of maps that are on or not, with the matrix of their links by rows.
std::vector<LinkState> statesOf(std::vector<double> matrix, const std::vector<char>& on);

// The maps of each strongly connected part of the graph of positive entries, in increasing order; a map that
// no cycle passes is a part of its own. Parts that lead to others come after them.
std::vector<std::vector<std::size_t>> connectedParts(std::span<const double> matrix, std::size_t size);

// Builds the matrix, row by row, from links that name the ids of the maps; 1 where there is no link, 0 where
// a weight is negative or not finite.
template <class Maps, class Links> std::vector<double> matrixOf(const Maps& maps, const Links& links) {
    const std::size_t n = maps.size();
    std::vector<double> matrix(n * n, 1);
    if (links.empty()) return matrix;
    std::map<decltype(maps.front().id), std::size_t> rows;
    for (std::size_t i = 0; i < n; ++i)
        rows.emplace(maps[i].id, i);
    for (const auto& [fromId, toId, weight] : links) {
        const auto from = rows.find(fromId), to = rows.find(toId);
        if (from != rows.end() && to != rows.end())
            matrix[from->second * n + to->second] = weight > 0 && std::isfinite(weight) ? weight : 0;
    }
    return matrix;
}

} // namespace ifs
