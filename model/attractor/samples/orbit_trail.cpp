// SPDX-License-Identifier: MIT
#include "attractor/samples/orbit_trail.h"

#include <algorithm>

namespace attractor {

OrbitTrail::OrbitTrail(PreparedSystem system, std::uint64_t seed)
    : m_system(std::move(system)), m_seed(seed) {}

std::span<const OrbitTrail::Point> OrbitTrail::after(std::uint64_t jumps) {
    if (m_system.maps.empty()) return {};
    if (!m_orbit || jumps < m_jumps) {
        m_orbit = std::make_unique<Orbit>(m_system, m_seed, 0);
        m_jumps = 0;
        m_points.clear();
    }
    for (; m_jumps < jumps; ++m_jumps) {
        const Orbit::Point point = m_orbit->next();
        if (m_points.size() == 2 * longest)
            m_points.erase(m_points.begin(), m_points.begin() + std::ptrdiff_t(longest));
        m_points.push_back({point.x, m_system.index[point.lastMap]});
    }
    return std::span(m_points).last(std::min(m_points.size(), longest));
}

} // namespace attractor
