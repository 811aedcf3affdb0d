// SPDX-License-Identifier: MIT
#include "attractor/request/colour_coordinates.h"

#include <algorithm>
#include <utility>

namespace attractor {

ColourCoordinates::ColourCoordinates(std::vector<MapBlend> blends, std::span<const double> probabilities)
    : m_maps(blends.size()), m_blends(std::move(blends)) {
    double pull = 0;
    double sum = 0;
    double lowest = 1;
    double highest = 0;
    for (std::size_t i = 0; i < m_maps; ++i) {
        const MapBlend& blend = m_blends[i];
        if (!(blend.speed > 0)) continue;
        pull += probabilities[i] * blend.speed;
        sum += probabilities[i] * blend.speed * blend.coordinate;
        lowest = std::min(lowest, blend.coordinate);
        highest = std::max(highest, blend.coordinate);
    }
    // No pull: all points keep their first coordinate.
    if (pull > 0) m_mean = std::clamp(sum / pull, lowest, highest);
    m_range = std::max(0.0, highest - lowest);
}

MapBlend addressBlend(std::size_t index, std::size_t maps) {
    if (maps < 2) return {0, 0}; // constant c
    const auto last = static_cast<double>(maps - 1);
    return {static_cast<double>(index) / last, last / static_cast<double>(maps)};
}

template <int Dim>
ColourCoordinates colourCoordinates(const Appearance& appearance,
                                    const ifs::IteratedFunctionSystem<Dim>& system,
                                    const ifs::ActiveMaps<Dim>& active) {
    if (appearance.colourBy != ColourBy::Blend) return ColourCoordinates(active.maps.size());
    std::vector<MapBlend> blends;
    blends.reserve(active.index.size());
    for (const std::size_t index : active.index)
        blends.push_back(mapBlend(appearance, system.maps[index].id, index, system.maps.size()));
    return {std::move(blends), active.probabilities};
}

template ColourCoordinates colourCoordinates<2>(const Appearance&, const ifs::IteratedFunctionSystem<2>&,
                                                const ifs::ActiveMaps<2>&);
template ColourCoordinates colourCoordinates<3>(const Appearance&, const ifs::IteratedFunctionSystem<3>&,
                                                const ifs::ActiveMaps<3>&);

} // namespace attractor
