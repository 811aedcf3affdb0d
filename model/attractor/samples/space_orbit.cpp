// SPDX-License-Identifier: MIT
#include "attractor/samples/space_orbit.h"

#include "attractor/arithmetic/arithmetic.h"

#include <utility>

namespace attractor {

SpaceOrbit::SpaceOrbit(const PreparedSpace& system, std::uint64_t seed, ColourCoordinates colours)
    : m_system(&system),
      m_colours(colours.empty() ? ColourCoordinates(system.maps.size()) : std::move(colours)),
      m_table(system.probabilities),
      m_random(mixed(seed)) {
    m_point.colourCoordinate = m_colours.beginning();
    m_point.x = ifs::fixedPoint(system.maps.front()).value_or(ifs::Vector<3>::Zero());
    m_farAway = 1e6 * (system.halfExtent.maxCoeff() + (m_point.x - system.centre).cwiseAbs().maxCoeff());
    for (int n = 0; n < Orbit::skipped; ++n)
        next();
}

const SpaceOrbit::Point& SpaceOrbit::next() {
    const std::uint32_t i = m_table.draw(static_cast<std::uint32_t>(mixed(m_random++) >> 32));
    m_point.x = m_system->maps[i](m_point.x);
    m_point.lastMap = i;
    m_point.addressCoordinate = (i + m_point.addressCoordinate) / static_cast<double>(m_system->maps.size());
    m_point.colourCoordinate = m_colours.next(i, m_point.colourCoordinate);
    if (!((m_point.x - m_system->centre).cwiseAbs().maxCoeff() <= m_farAway)) m_point.x = m_system->centre;
    return m_point;
}

} // namespace attractor
