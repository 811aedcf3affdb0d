// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/samples/rounded_map.h"

#include <cstddef>
#include <unordered_map>

namespace attractor {

// Nodes that show the same to a millionth of a cell become one, with the measure of all. Otherwise each of
// them would take its samples from the same set to the same cells, and a picture would be as noisy as one of
// fewer samples. The first one stays, in its place.
template <typename Nodes> void mergeCoinciding(Nodes& nodes) {
    constexpr double perCell = 0x1p20;
    std::unordered_map<RoundedMap, std::size_t, RoundedMapHash> known;
    known.reserve(nodes.size());
    std::size_t kept = 0;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const auto& shown = nodes[k].shown;
        const RoundedMap map({shown.xx, shown.xy, shown.yx, shown.yy, shown.x, shown.y}, perCell);
        const auto [at, isNew] = known.try_emplace(map, kept);
        if (isNew)
            nodes[kept++] = nodes[k];
        else
            nodes[at->second].probability += nodes[k].probability;
    }
    nodes.resize(kept);
}

} // namespace attractor
