// SPDX-License-Identifier: MIT
#include "attractor/folds/chaos_game_fold.h"

#include <algorithm>

namespace attractor {

void ChaosGameFold::rewind(const CellWindow& window) {
    SumFold::rewind(window);
    m_orbit.reset();
}

void ChaosGameFold::begin(std::uint64_t samples) {
    const std::uint64_t wanted = prepared().request().samples;
    SumFold::begin(std::min(samples, wanted - std::min(wanted, this->samples())));
}

bool ChaosGameFold::complete(const std::stop_token& stop) {
    constexpr std::uint64_t together = 8192; // between two checks of the stop token
    const PreparedRequest& request = prepared();
    if (!m_orbit)
        m_orbit.emplace(request.system(), request.request().seed, Orbit::skipped, request.coordinates());
    while (remaining() > 0) {
        if (stop.stop_requested()) return false;
        const std::uint64_t run = std::min(remaining(), together);
        makeRoomFor(run);
        for (std::uint64_t n = 0; n < run; ++n) {
            const Orbit::Point point = m_orbit->next();
            plot(point.x,
                 request.coloured() ? &request.colourOf(point.lastMap, point.colourCoordinate) : nullptr, 0);
        }
        counted(run);
        settle(run, run);
        forgetExposure(); // too few points for an exposure
    }
    return true;
}

} // namespace attractor
