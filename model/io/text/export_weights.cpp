// SPDX-License-Identifier: MIT
#include "io/text/export_weights.h"
#include "document/text/text.h"

namespace io {

template <int Dim> std::vector<double> exportWeights(const ifs::IteratedFunctionSystem<Dim>& system) {
    auto unlinked = system; // keeps weights of maps to which no link leads
    unlinked.links.clear();
    const std::vector<double> probabilities = ifs::probabilities(unlinked);
    bool allGiven = true;
    for (std::size_t i = 0; i < system.maps.size(); ++i)
        allGiven = allGiven && (probabilities[i] == 0 || system.maps[i].weight);
    std::vector<double> weights(system.maps.size());
    for (std::size_t i = 0; i < system.maps.size(); ++i)
        if (probabilities[i] > 0) weights[i] = allGiven ? *system.maps[i].weight : probabilities[i];
    return weights;
}

template std::vector<double> exportWeights(const ifs::IteratedFunctionSystem<2>&);
template std::vector<double> exportWeights(const ifs::IteratedFunctionSystem<3>&);

std::optional<QString> weightRemark(std::size_t map, double weight) {
    if (weight < 0)
        return Text::tr("The weight of map %1 is negative; the map is treated as switched off.").arg(map);
    if (weight == 0) return Text::tr("The weight of map %1 is 0, so the map is inactive.").arg(map);
    return std::nullopt;
}

QString missingWeightRemark(std::size_t map) {
    return Text::tr("Map %1 has no weight, so all weights are computed from the "
                    "determinants and the given ones are ignored.")
        .arg(map);
}

} // namespace io
