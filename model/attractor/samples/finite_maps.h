// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/system/affine_map.h"
#include "ifs/system/iterated_function_system.h"

#include <cstddef>

namespace attractor {

// The active maps of finite coefficients; their probabilities sum to 1.
template <int Dim> ifs::ActiveMaps<Dim> finiteMaps(const ifs::IteratedFunctionSystem<Dim>& system) {
    const ifs::ActiveMaps<Dim> active = ifs::activeMaps(system);
    if (active.isLinked()) { // drops maps that only dropped maps lead to
        ifs::IteratedFunctionSystem<Dim> finite = system;
        for (auto& map : finite.maps)
            map.enabled = map.enabled && ifs::isFinite(map.map);
        return ifs::activeMaps(finite);
    }
    ifs::ActiveMaps<Dim> result;
    double total = 0;
    for (std::size_t i = 0; i < active.maps.size(); ++i) {
        if (!ifs::isFinite(active.maps[i])) continue;
        result.maps.push_back(active.maps[i]);
        result.probabilities.push_back(active.probabilities[i]);
        result.index.push_back(active.index[i]);
        total += active.probabilities[i];
    }
    for (double& p : result.probabilities)
        p /= total;
    return result;
}

} // namespace attractor
