// SPDX-License-Identifier: MIT
#include "io/written_weights.h"

namespace io {

std::vector<double> writtenWeights(const ifs::IteratedFunctionSystem<2>& system) {
    const auto active = ifs::activeMaps(system);
    bool allGiven = true;
    for (const std::size_t i : active.index)
        allGiven = allGiven && system.maps[i].weight;
    std::vector<double> weights(system.maps.size());
    for (std::size_t k = 0; k < active.index.size(); ++k) {
        const std::size_t i = active.index[k];
        weights[i] = allGiven ? *system.maps[i].weight : active.probabilities[k];
    }
    return weights;
}

} // namespace io
