// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/arithmetic/arithmetic.h"

#include <cstddef>
#include <cstdint>

namespace attractor {

// Overlapping systems have exponentially many words in a small view. A systematic sample of them, each
// standing for its share, keeps every estimate unbiased. Nodes likelier than a share, 2/wanted of the whole,
// stay as they are; of the others, about wanted/2 stay and take the probability of a share. The order is
// kept. `draw` decides where the sample begins. A node has a positive `probability`.
template <typename Nodes> void thinOut(Nodes& nodes, std::size_t wanted, std::uint64_t draw) {
    double total = 0;
    for (const auto& node : nodes)
        total += node.probability;
    const double share = 2 * total / static_cast<double>(wanted);
    double sum = static_cast<double>(mixed(draw) >> 11) * 0x1p-53 * share;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        auto node = nodes[k];
        if (node.probability < share) {
            sum += node.probability;
            if (sum < share) continue;
            sum -= share;
            node.probability = share;
        }
        nodes[kept++] = node;
    }
    nodes.resize(kept);
}

} // namespace attractor
