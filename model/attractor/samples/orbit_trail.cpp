// SPDX-License-Identifier: MIT
#include "attractor/samples/orbit_trail.h"

namespace attractor {

OrbitTrail::OrbitTrail(PreparedSystem system, std::uint64_t seed)
    : m_system(std::move(system)), m_seed(seed) {}

const std::vector<OrbitTrail::Point>& OrbitTrail::after(std::uint64_t plotted) {
    if (m_system.maps.empty()) return m_points;
    if (!m_orbit || plotted < m_plotted) {
        m_orbit = std::make_unique<Orbit>(m_system, m_seed);
        m_plotted = 0;
        m_points.clear();
    }
    for (; m_plotted < plotted; ++m_plotted) {
        const Orbit::Point point = m_orbit->next();
        if (plotted - m_plotted > longest) continue;
        if (m_points.size() == longest) m_points.erase(m_points.begin());
        m_points.push_back({point.x, m_system.index[point.lastMap]});
    }
    return m_points;
}

} // namespace attractor
